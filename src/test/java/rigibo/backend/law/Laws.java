package rigibo.backend.law;

import static org.assertj.core.api.Assertions.fail;

import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongFunction;

/** Holds a law against many scenes and cuts the first one that breaks it down to a few bodies. */
final class Laws {

    private Laws() {}

    /** Fails at the first seed whose scene breaks the law, or when all ask it too little. */
    static void hold(Seeds seeds, LongFunction<RandomScene> maker, Law law, Quota quota) {
        Asked asked = new Asked();
        for (long seed : seeds.asked()) {
            RandomScene scene = maker.apply(seed);
            Optional<String> broken = judge(law, scene, asked);
            if (broken.isPresent()) {
                fail(report(scene, broken.get(), law));
            }
        }
        Preset preset = Preset.of(maker.apply(seeds.all().get(0)).accuracy());
        LawTable.note(seeds, preset, asked, quota);
        long least = quota.leastOf(seeds);
        if (asked.times() < least) {
            fail("asked %d of at least %d %s", asked.times(), least, quota.what());
        }
    }

    /** An engine that throws breaks every law. */
    private static Optional<String> judge(Law law, RandomScene scene, Asked asked) {
        try {
            return law.broken(scene, asked);
        } catch (RuntimeException | AssertionError thrown) {
            StackTraceElement[] trace = thrown.getStackTrace();
            return Optional.of(thrown + (trace.length > 0 ? " at " + trace[0] : ""));
        }
    }

    private static Optional<String> judge(Law law, RandomScene scene) {
        return judge(law, scene, new Asked());
    }

    private static String report(RandomScene scene, String words, Law law) {
        RandomScene small = cutDown(scene, law);
        return String.format(
                "seed %d: %s%nwith %d of its %d bodies: %s%n%s",
                scene.seed(),
                words,
                small.bodies().size(),
                scene.bodies().size(),
                judge(law, small).orElse("nothing"),
                small.words());
    }

    /** Leaves out one half, then quarters, down to single bodies, as long as the law breaks. */
    static RandomScene cutDown(RandomScene scene, Law law) {
        RandomScene small = scene;
        int part = scene.bodies().size() / 2;
        while (part > 0) {
            Optional<RandomScene> smaller = firstBroken(small, part, law);
            if (smaller.isPresent()) {
                small = smaller.get();
                part = Math.min(part, small.bodies().size() / 2);
            } else {
                part /= 2;
            }
        }
        return small;
    }

    private static Optional<RandomScene> firstBroken(RandomScene scene, int part, Law law) {
        for (int from = 0; from < scene.bodies().size(); from += part) {
            List<BodyDefinition> left = new ArrayList<>(scene.bodies());
            left.subList(from, Math.min(from + part, left.size())).clear();
            RandomScene smaller = scene.bodies(left);
            if (smaller.canMove() && judge(law, smaller).isPresent()) {
                return Optional.of(smaller);
            }
        }
        return Optional.empty();
    }
}

package rigibo.backend.law;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The laws of motion do not know who computes. */
@Execution(ExecutionMode.CONCURRENT)
class WorkersLawTest {

    private static final Seeds SEEDS = Seeds.upTo(10);

    /** Trays side by side, so that there are islands to share. */
    private static final int TRAYS = 16;

    /** m, from tray to tray. */
    private static final double APART = 100;

    private static final int WORKERS = 3;

    /** A second: all fall, meet and pile up. */
    private static final int STEPS = 60;

    @ParameterizedTest
    @EnumSource(Preset.class)
    void anyNumberOfWorkersMakesTheSameBits(Preset preset) {
        Laws.hold(
                SEEDS,
                seed -> trays(seed, preset.accuracy),
                WorkersLawTest::sameByWorkers,
                new Quota(1_000, "shared islands"));
    }

    private static RandomScene trays(long seed, Accuracy accuracy) {
        RandomScene first = Surroundings.tray(seed, accuracy);
        List<BodyDefinition> bodies = new ArrayList<>(first.bodies());
        List<Link> links = new ArrayList<>(Links.on(first).links());
        for (int i = 1; i < TRAYS; i++) {
            double aside = APART * i;
            List<BodyDefinition> more = new ArrayList<>();
            Surroundings.tray(seed + i * SEEDS.all().size(), accuracy)
                    .bodies()
                    .forEach(body -> more.add(body.at(body.x() + aside, body.y())));
            bodies.addAll(more);
            if (i % 2 == 0) {
                links.addAll(Links.on(first.bodies(more)).links());
            }
        }
        return Links.on(first).bodies(bodies).links(links).steps(STEPS);
    }

    static Optional<String> sameByWorkers(RandomScene scene, Asked asked) {
        int different = 0;
        try (Pool one = scene.pool();
                Pool several = scene.pool()) {
            several.workers(WORKERS);
            for (int i = 0; i < scene.steps(); i++) {
                one.step(RandomScene.DT);
                asked.more(several.step(RandomScene.DT).sharedIslands());
                different += one.stateHash() == several.stateHash() ? 0 : 1;
            }
        }
        return asked.atMost(0, different, "steps with other bits:");
    }
}

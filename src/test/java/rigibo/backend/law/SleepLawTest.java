package rigibo.backend.law;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyType;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Sleep saves time and changes nothing else. Only scenes of which all fell asleep are compared: the
 * bodies in them are what is counted.
 */
@Execution(ExecutionMode.CONCURRENT)
class SleepLawTest {

    private static final Sleep SLEEP = new Sleep();

    /** Few enough to come to rest side by side: nobody is tossed onto what sleeps. */
    private static final int FEW = 4;

    private static final int MANY = 9;

    /** Five seconds, ten times what it takes to fall asleep. */
    private static final int STEPS_GOING_ON = 300;

    @ParameterizedTest
    @CsvSource({"DRAFT, 150, 200", "GAME, 250, 300", "FINE, 100, 130", "EXACT, 16, 17"})
    void bodiesEndWhereTheyWouldWithoutSleep(Preset preset, long scenes, long bodies) {
        holdFew(preset, Seeds.upTo(scenes), SleepLawTest::sameWithoutSleep, bodies);
    }

    @ParameterizedTest
    @CsvSource({"DRAFT, 150, 200", "GAME, 250, 300", "FINE, 100, 130", "EXACT, 16, 17"})
    void fewThatSleepWouldNotHaveMoved(Preset preset, long scenes, long bodies) {
        holdFew(preset, Seeds.upTo(scenes), SleepLawTest::stillWithoutSleep, bodies);
    }

    @ParameterizedTest
    @CsvSource({"DRAFT, 200, 500", "GAME, 150, 380", "FINE, 50, 135"})
    void heapsThatSleepWouldNotHaveMoved(Preset preset, long scenes, long bodies) {
        Laws.hold(
                Seeds.upTo(scenes),
                seed -> Surroundings.settling(seed, preset.accuracy, MANY),
                SleepLawTest::stillWithoutSleep,
                new Quota(bodies, "bodies asleep"));
    }

    private static void holdFew(Preset preset, Seeds seeds, Law law, long bodies) {
        Laws.hold(
                seeds,
                seed -> Surroundings.settling(seed, preset.accuracy, FEW),
                law,
                new Quota(bodies, "bodies asleep"));
    }

    static Optional<String> sameWithoutSleep(RandomScene scene, Asked asked) {
        Pool asleep = withSleep(scene).finished();
        if (!isAsleep(asleep)) {
            return Optional.empty();
        }
        return near(states(scene.finished()), asleep, asked);
    }

    /**
     * Bodies that have fallen asleep are woken and simulated without sleep: they must stay in
     * place.
     */
    static Optional<String> stillWithoutSleep(RandomScene scene, Asked asked) {
        Pool pool = withSleep(scene).finished();
        if (!isAsleep(pool)) {
            return Optional.empty();
        }
        List<State> asleep = states(pool);
        pool.effects(scene.effects());
        for (int i = 0; i < STEPS_GOING_ON; i++) {
            pool.step(RandomScene.DT);
        }
        return near(asleep, pool, asked);
    }

    private static RandomScene withSleep(RandomScene scene) {
        return scene.effects(scene.effects().with(SLEEP));
    }

    private static boolean isAsleep(Pool pool) {
        return pool.bodies().stream().noneMatch(RigidBody::isAwake);
    }

    private static List<State> states(Pool pool) {
        return pool.bodies().stream().map(State::of).collect(Collectors.toList());
    }

    private static Optional<String> near(List<State> expected, Pool pool, Asked asked) {
        double off = 0;
        for (int i = 0; i < expected.size(); i++) {
            RigidBody body = pool.bodies().get(i);
            if (body.type() == BodyType.DYNAMIC) {
                double width = body.shape().smallestWidth();
                off = Math.max(off, expected.get(i).off(State.of(body)) / width);
                asked.more(1);
            }
        }
        return asked.atMost(SLEEP.distance(), off, "off by widths");
    }
}

package rigibo.backend.law;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.Pool;
import rigibo.backend.setup.BodyType;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** A pool restored at any step goes on to the same bits and the same hash, whatever is declared. */
@Execution(ExecutionMode.CONCURRENT)
class SnapshotLawTest {

    private static final int STEPS = 160;

    /** Snapshots that each program is restored from at drawn steps. */
    private static final int SNAPSHOTS = 3;

    @ParameterizedTest
    @CsvSource({"DRAFT, 30, 300", "GAME, 30, 300", "FINE, 15, 100", "EXACT, 8, 70"})
    void restoredPoolGoesOnToTheSameBits(Preset preset, long scenes, long sleepers) {
        Laws.hold(
                Seeds.upTo(scenes),
                seed -> RandomProgram.scene(seed, preset.accuracy),
                SnapshotLawTest::goesOn,
                new Quota(sleepers, "steps with sleepers of a restored pool"));
    }

    private static Optional<String> goesOn(RandomScene scene, Asked asked) {
        Pool pool = scene.pool();
        Draw draw = new Draw(scene.seed());
        List<Integer> taken = draw.steps(SNAPSHOTS, STEPS);
        Pool restored = null;
        int at = 0;
        for (int i = 0; i < STEPS; i++) {
            if (taken.contains(i)) {
                at = i;
                restored = Pool.restore(pool.snapshot(), scene.effects());
            }
            RandomProgram.step(pool, scene.seed(), i);
            if (restored != null) {
                RandomProgram.step(restored, scene.seed(), i);
                if (differ(pool, restored)) {
                    return Optional.of("restored before step " + at + ", other after " + i);
                }
                asked.more(hasSleepers(restored) ? 1 : 0);
            }
        }
        return Arrays.equals(pool.snapshot(), restored.snapshot())
                ? Optional.empty()
                : Optional.of("restored before step " + at + ", another snapshot at the end");
    }

    /** By hash, and by what can be seen, which a hash that forgets would not tell. */
    private static boolean differ(Pool pool, Pool restored) {
        return pool.stateHash() != restored.stateHash() || !seen(pool).equals(seen(restored));
    }

    private static List<State> seen(Pool pool) {
        return pool.bodies().stream().map(State::of).collect(Collectors.toList());
    }

    private static boolean hasSleepers(Pool pool) {
        return pool.bodies().stream()
                .anyMatch(body -> body.type() == BodyType.DYNAMIC && !body.isAwake());
    }
}

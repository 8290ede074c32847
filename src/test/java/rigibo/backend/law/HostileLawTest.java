package rigibo.backend.law;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;

import java.util.ArrayList;
import java.util.List;

/**
 * Whatever numbers a pool accepts, a step ends with finite ones, and bodies far away are not
 * affected.
 */
@Execution(ExecutionMode.CONCURRENT)
class HostileLawTest {

    private static final int SCENES = 8;
    private static final int STEPS = 5;

    /** Each of these eights holds a scene that once broke off, spread, or pushed what is fixed. */
    @ParameterizedTest
    @ValueSource(longs = {1, 105, 135, 250, 290, 425, 460})
    void oneSickBodyNeverSpreads(long firstSeed) {
        for (long seed = firstSeed; seed < firstSeed + SCENES; seed++) {
            requireHealth(seed);
        }
    }

    private static void requireHealth(long seed) {
        HostileScene scene = new HostileScene(seed);
        Pool pool = scene.withSick();
        Pool healthy = scene.healthy();
        List<State> before = motions(pool);
        for (int step = 0; step < STEPS; step++) {
            double dt = scene.length();
            String where = "seed " + seed + ", step " + step + " of " + dt + " s";
            scene.push(pool);
            pool.step(dt);
            healthy.step(dt);
            List<State> after = motions(pool);
            assertThat(after).as(where).allMatch(State::isFinite);
            assertThat(after.subList(0, healthy.bodies().size()))
                    .as("strangers, %s", where)
                    .isEqualTo(motions(healthy));
            requireUnmoved(pool, before, after, where);
            Pool restored = Pool.restore(pool.snapshot(), scene.effects);
            assertThat(restored.stateHash()).as(where).isEqualTo(pool.stateHash());
        }
    }

    private static List<State> motions(Pool pool) {
        List<State> motions = new ArrayList<>();
        pool.bodies().forEach(body -> motions.add(State.of(body)));
        return motions;
    }

    /** Static bodies stay; kinematic ones move at their velocity. */
    private static void requireUnmoved(
            Pool pool, List<State> before, List<State> after, String where) {
        for (int i = 0; i < before.size(); i++) {
            RigidBody body = pool.bodies().get(i);
            State was = before.get(i);
            State is = after.get(i);
            if (body.type() == BodyType.STATIC) {
                assertThat(is).as("fixed body %d, %s", i, where).isEqualTo(was);
            } else if (body.type() == BodyType.KINEMATIC) {
                assertThat(List.of(is.velocityX(), is.velocityY(), is.spin()))
                        .as("driven body %d, %s", i, where)
                        .isEqualTo(List.of(was.velocityX(), was.velocityY(), was.spin()));
            }
        }
    }
}

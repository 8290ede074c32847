package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.BodyDefinition;

/** Joined sleepers that are woken within a step. */
class StruckSleepersTest {

    private static final Effects EARTH = JointScenes.EARTH.with(new Friction()).with(new Sleep());

    /**
     * A ball strikes one of five planks that are hinged in a row and asleep. The hinges hold in the
     * step that wakes them as in every other one: they may miss by what joints may at that accuracy
     * (0.1 mm at GAME, 1 nm at EXACT). Without them the plank would leave its neighbours at some
     * m/s, by centimetres in a step.
     */
    @ParameterizedTest
    @CsvSource({"DRAFT, 1e-3", "GAME, 1e-4", "FINE, 1e-6", "EXACT, 1e-9"})
    void sleepersThatAreStruckStayJoined(Preset preset, double most) {
        Pool pool = new Pool(EARTH, preset.accuracy);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5));
        RigidBody before = null;
        for (int i = 0; i < 5; i++) {
            RigidBody plank = JointScenes.bone(pool, i, 0.1, 1, 0.2);
            if (before != null) {
                pool.join(RevoluteJoint.at(before, plank, i - 0.5, 0.1));
            }
            before = plank;
        }
        for (int i = 0; i < 120; i++) {
            pool.step(Scenes.DT);
        }
        assertThat(before.isAwake()).isFalse();
        pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(4.45, 3).velocity(0, -8).mass(5));
        for (int i = 0; i < 60; i++) {
            pool.step(Scenes.DT);
            for (Joint joint : pool.joints()) {
                assertThat(joint.error()).as("m after step %d", i).isLessThan(most);
            }
        }
        assertThat(pool.time()).isGreaterThan(0);
    }
}

package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.List;
import java.util.Random;

/** Sleepers that are woken within a step. */
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

    /**
     * Boxes on a smooth floor, some touching and some apart, are struck from one end at 3 to 60 m/s
     * when they have fallen asleep. Each is driven into the next within the same step. Where they
     * go is known from the same row that never slept: sleep may change nothing but the order in
     * which a solver meets the rows, so what differs is what that solver may leave. At DRAFT, which
     * lets bodies sink in, a sleeper wakes from a tenth of its width on, here at most 5 cm.
     */
    @ParameterizedTest
    @CsvSource({"DRAFT, 0.05", "GAME, 1e-5", "FINE, 1e-6", "EXACT, 1e-9"})
    void rowsMoveAsIfTheyHadNotSlept(Preset preset, double most) {
        int slept = 0;
        for (long seed = 0; seed < 40; seed++) {
            Pool sleeping = row(seed, Effects.usual(), preset);
            Pool sleepless = row(seed, Effects.usual().without(Sleep.class), preset);
            for (RigidBody box : sleeping.bodies()) {
                slept += box.type() == BodyType.DYNAMIC && !box.isAwake() ? 1 : 0;
            }
            Random speeds = new Random(seed);
            double speed = 3 * Math.pow(20, speeds.nextDouble());
            sleeping.bodies().get(1).velocity(speed, 0);
            sleepless.bodies().get(1).velocity(speed, 0);
            for (int i = 0; i < 20; i++) {
                sleeping.step(Scenes.DT);
                sleepless.step(Scenes.DT);
            }
            for (int i = 1; i < sleeping.bodies().size(); i++) {
                assertThat(sleeping.bodies().get(i).x())
                        .as("box %d of row %d, m", i, seed)
                        .isCloseTo(sleepless.bodies().get(i).x(), within(most));
            }
        }
        assertThat(slept).as("boxes that slept").isGreaterThan(200);
    }

    /**
     * Boxes in a row keep their order, whatever strikes them; no box is on both sides of another.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void rowsKeepTheirOrder(Preset preset) {
        for (long seed = 0; seed < 40; seed++) {
            Pool pool = row(seed, Effects.usual(), preset);
            List<RigidBody> bodies = pool.bodies();
            bodies.get(1).velocity(3 * Math.pow(20, new Random(seed).nextDouble()), 0);
            for (int i = 0; i < 60; i++) {
                pool.step(Scenes.DT);
                for (int k = 2; k < bodies.size(); k++) {
                    assertThat(bodies.get(k).x())
                            .as("box %d of row %d, m", k, seed)
                            .isGreaterThan(bodies.get(k - 1).x());
                }
            }
        }
    }

    /** A floor, and a row of boxes on it that have lain still for a second. */
    private static Pool row(long seed, Effects effects, Preset preset) {
        Random random = new Random(seed);
        Material smooth = Material.DEFAULT.friction(0).elasticity(0);
        Pool pool = new Pool(effects, preset.accuracy);
        pool.add(BodyDefinition.fixed(Polygon.box(400, 2)).at(0, -1).material(smooth));
        double end = 0;
        for (int i = 0; i < 4 + seed % 5; i++) {
            double width = 0.2 + 0.6 * random.nextDouble();
            double mass = Math.pow(10, 2 * random.nextDouble() - 1);
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(width, 0.5))
                            .at(end + width / 2, 0.25)
                            .mass(mass)
                            .material(smooth));
            double gap = Math.pow(10, 2.5 * random.nextDouble() - 3);
            end += width + (random.nextInt(3) == 0 ? 0 : gap);
        }
        for (int i = 0; i < 60; i++) {
            pool.step(Scenes.DT);
        }
        return pool;
    }
}

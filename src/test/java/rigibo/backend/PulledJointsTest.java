package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Friction;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.SplittableRandom;

/** Springs, hands and ropes that pull far harder than anything weighs. */
class PulledJointsTest {

    /** Limit of J1 at GAME for a joint's error, m; and for energy, as a share. */
    private static final double OPEN = 1e-4;

    private static final double SHARE = 1e-3;

    private static Accuracy accuracy(String preset) {
        return preset.equals("DRAFT") ? Accuracy.DRAFT : Accuracy.GAME;
    }

    /**
     * A hand draws a bar by some thousand times its weight against the limit of its hinge. The hand
     * belongs to a box that falls on the floor beside it, so that all of them are one island. The
     * torque at the limit is constant, and so is what the hand stores.
     */
    @ParameterizedTest
    @ValueSource(strings = {"DRAFT", "GAME"})
    void limitsHoldAgainstStrongHandsWhileOthersFall(String preset) {
        SplittableRandom random = new SplittableRandom(11);
        int landed = 0;
        for (int i = 0; i < 20; i++) {
            Pool pool = new Pool(JointScenes.EARTH.with(new Friction()), accuracy(preset));
            RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
            RigidBody bar = pool.add(BodyDefinition.dynamic(Polygon.box(0.2, 0.8)).at(-3, 2));
            RigidBody box = box(pool, random);
            Joint hinge = pool.join(RevoluteJoint.at(floor, bar, -3, 2.4).limits(-0.2, 0.03, 0));
            MouseJoint hand = MouseJoint.of(box, bar, -3, 1.6).target(2, 2 + random.nextDouble());
            pool.join(hand.spring(3 + 4 * random.nextDouble(), 0.3));
            for (int step = 0; step < 30; step++) {
                pool.step(Scenes.DT);
            }
            double before = JointScenes.energy(pool);
            for (int step = 0; step < 90; step++) {
                pool.step(Scenes.DT);
                double now = JointScenes.energy(pool);
                assertThat(hinge.angle()).as("limit in scene " + i).isLessThan(0.03 + OPEN);
                assertThat(now).as("energy in scene " + i).isLessThan(before + SHARE * before);
                before = now;
            }
            landed += box.y() < 0.6 ? 1 : 0;
        }
        assertThat(landed).isGreaterThan(15);
    }

    private static RigidBody box(Pool pool, SplittableRandom random) {
        return pool.add(
                BodyDefinition.dynamic(Polygon.box(0.4, 0.3))
                        .at(1, 1 + random.nextDouble())
                        .angle(6 * random.nextDouble())
                        .spin(8 * random.nextDouble())
                        .material(new Material(1, 0.3, 0.6)));
    }

    /** A spring drives a puck of a kilogram from rest into a wall within the first step. */
    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.05, 0.1, 0.2})
    void whatIsLetGoIsStoppedByTheWallBeforeIt(double gap) {
        Pool pool = new Pool(JointScenes.SPACE, Accuracy.GAME);
        RigidBody puck = pool.add(BodyDefinition.dynamic(Polygon.box(0.2, 0.2)).mass(1));
        RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 2)).at(0.2 + gap, 0));
        pool.join(MouseJoint.of(wall, puck, 0, 0).target(3, 0).spring(8, 0));
        boolean hasMet = false;
        for (int step = 0; step < 10; step++) {
            double overlap = pool.step(Scenes.DT).deepestOverlap();
            hasMet |= pool.touching(puck, wall);
            assertThat(overlap).as("step " + step).isLessThan(0.02 * 0.2);
        }
        assertThat(hasMet).isTrue();
    }

    /** A weight draws the other one sideways up to the pulley, about which its rope whirls. */
    @ParameterizedTest
    @ValueSource(strings = {"DRAFT", "GAME"})
    void ropesDrawnInToTheirPulleysKeepTheirEnergy(String preset) {
        SplittableRandom random = new SplittableRandom(5);
        int drawnIn = 0;
        for (int i = 0; i < 20; i++) {
            Pool pool = new Pool(JointScenes.EARTH, accuracy(preset));
            RigidBody light = weight(pool, -1, 2.5, 1, 2 + 3 * random.nextDouble());
            RigidBody heavy = weight(pool, 1, 2, 3 + 3 * random.nextDouble(), 0);
            pool.join(PulleyJoint.over(light, heavy, 4));
            double scale = JointScenes.G * (light.mass() + heavy.mass()) * 4;
            double before = JointScenes.energy(pool);
            double nearest = 4;
            for (int step = 0; step < 120; step++) {
                pool.step(Scenes.DT);
                double now = JointScenes.energy(pool);
                assertThat(now - before).as("scene " + i).isLessThan(SHARE * scale);
                before = now;
                nearest = Math.min(nearest, Math.hypot(light.x() + 1, light.y() - 4));
            }
            drawnIn += nearest < 0.4 ? 1 : 0;
        }
        assertThat(drawnIn).isGreaterThan(10);
    }

    private static RigidBody weight(Pool pool, double x, double y, double mass, double speed) {
        return pool.add(
                BodyDefinition.dynamic(new Circle(0.1))
                        .at(x, y)
                        .mass(mass)
                        .velocity(speed, 0)
                        .group(-1));
    }
}

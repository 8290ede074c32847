package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Material;
import rigibo.lab.hardcase.Preset;

import java.util.ArrayList;
import java.util.List;

/**
 * A heavy box that is laid onto the middle of a row of n light planks of length l, as long as its
 * span. Hinges that are e apart let the row sag by n·√(l·e/2).
 */
class TautRowTest {

    private static final double LENGTH = 0.5;
    private static final double GRAVITY = 9.81;
    private static final double DT = 1.0 / 60;

    /** The energy gained in a step, as a share of that of the box's fall by a plank's length. */
    private static final double GAINED = 1e-3;

    private static final double GAINED_AT_DRAFT = 1e-2;

    private final List<RigidBody> planks = new ArrayList<>();

    /** Friction in hinges takes part of the load, up to a tenth of it here. */
    @ParameterizedTest
    @CsvSource({
        "GAME, 10, 0",
        "GAME, 25, 0",
        "GAME, 40, 0",
        "GAME, 10, 1",
        "GAME, 25, 5",
        "DRAFT, 10, 0",
        "DRAFT, 25, 0",
        "FINE, 10, 0",
        "FINE, 25, 0"
    })
    void sagsByTheGapsOfItsHingesAndRests(Preset preset, int count, double friction) {
        Accuracy accuracy = preset.accuracy();
        Pool pool = new Pool(Effects.usual().with(new Joints()), accuracy);
        lay(pool, count, friction);
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.3, 0.3))
                                .at(0, 0.21)
                                .mass(50 * planks.get(0).mass())
                                .material(new Material(1, 0.8, 0)));
        double aimed = 0.1 * accuracy.impactTolerance() * LENGTH;
        double energy = energy(pool);
        double share = preset == Preset.DRAFT ? GAINED_AT_DRAFT : GAINED;
        double most = share * box.mass() * GRAVITY * LENGTH;
        int steps = 0;
        while (pool.report().awake() > 0 || steps == 0) {
            pool.step(DT);
            double before = energy;
            energy = energy(pool);
            assertThat(energy - before).as("step " + steps).isLessThan(most);
            assertThat(steps++).as("steps").isLessThan(900);
        }
        double apart = 0;
        for (Joint joint : pool.joints()) {
            apart = Math.max(apart, joint.error());
        }
        assertThat(apart).isBetween(0.5 * aimed, 1.2 * aimed);
        double sag = -planks.stream().mapToDouble(RigidBody::y).min().orElseThrow();
        // The planks' own weight lets those beside the box sag, too.
        double expected = count * Math.sqrt(LENGTH * apart / 2);
        assertThat(sag).isCloseTo(expected, within(0.2 * expected));
    }

    /** A motor that pulls 200 times as hard as the row weighs explains its tension. */
    @Test
    void rowThatAMotorPullsStaysClosed() {
        Pool pool = new Pool(Effects.usual().with(new Joints()), Accuracy.GAME);
        RigidBody hook = lay(pool, 10, 0);
        pool.remove(hook);
        RigidBody last = planks.get(planks.size() - 1);
        double force = 200 * 10 * last.mass() * GRAVITY;
        RigidBody wall = hook(pool, 10);
        pool.join(new MotorJoint(wall, last, 1, 0, 0, force, 0, JointSettings.NONE));
        for (int step = 0; step < 120; step++) {
            pool.step(DT);
        }
        Joint first = pool.joints().get(0);
        assertThat(first.reactionForce()).isCloseTo(force, within(0.01 * force));
        for (Joint joint : pool.joints()) {
            // The error that a joint may have at GAME; springs would be 9 µm apart.
            assertThat(joint.error()).isLessThan(1e-6);
        }
    }

    private static double energy(Pool pool) {
        return pool.kineticEnergy() + pool.potentialEnergy();
    }

    /** Lays planks between two hooks; returns the right one. */
    private RigidBody lay(Pool pool, int count, double friction) {
        double left = -count * LENGTH / 2;
        RigidBody before = hook(pool, left);
        for (int i = 0; i < count; i++) {
            RigidBody plank =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(LENGTH, 0.1))
                                    .at(left + (i + 0.5) * LENGTH, 0)
                                    .material(new Material(100, 0.8, 0)));
            hinge(pool, before, plank, left + i * LENGTH, friction);
            planks.add(plank);
            before = plank;
        }
        RigidBody right = hook(pool, -left);
        hinge(pool, before, right, -left, friction);
        return right;
    }

    private static void hinge(Pool pool, RigidBody a, RigidBody b, double x, double friction) {
        RevoluteJoint hinge = RevoluteJoint.at(a, b, x, 0);
        pool.join(friction > 0 ? hinge.motor(0, friction) : hinge);
    }

    private static RigidBody hook(Pool pool, double x) {
        return pool.add(BodyDefinition.fixed(new Circle(0.01)).at(x, 0).filter(Filter.ALL.mask(0)));
    }
}

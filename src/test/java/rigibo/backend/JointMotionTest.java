package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Friction;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.List;

/** Motion and rest of joined bodies against their laws. */
class JointMotionTest {

    /** J3: energy of a double pendulum, and the order of its error in the step, within 2 s. */
    @Test
    void doublePendulumConvergesByOrderTwoAtLeast() {
        double[] x = new double[3];
        for (int i = 0; i < 3; i++) {
            Pool pool = new Pool(JointScenes.EARTH, Accuracy.EXACT.withSubsteps(4 << i));
            RigidBody tip = doublePendulum(pool, 0.5);
            Scenes.run(pool, 120);
            x[i] = tip.x();
        }
        double order = Math.log((x[1] - x[0]) / (x[2] - x[1])) / Math.log(2);
        assertThat(order).isGreaterThan(1.9);
    }

    /** J3: the limits are those of J1, in a motion that is chaotic. */
    @ParameterizedTest
    @CsvSource({"GAME, 1e-3", "EXACT, 1e-6"})
    void doublePendulumKeepsItsEnergy(String preset, double limit) {
        Pool pool = new Pool(JointScenes.EARTH, JointScenes.accuracy(preset));
        doublePendulum(pool, 2);
        double start = pool.kineticEnergy() + pool.potentialEnergy();
        for (int i = 0; i < 600; i++) {
            pool.step(Scenes.DT);
            double now = pool.kineticEnergy() + pool.potentialEnergy();
            assertThat(Math.abs(now - start) / (3 * JointScenes.G)).isLessThan(limit);
        }
    }

    private static RigidBody doublePendulum(Pool pool, double angle) {
        double x = Math.sin(angle);
        double y = -Math.cos(angle);
        BodyDefinition bar = BodyDefinition.dynamic(Polygon.box(0.1, 1)).angle(angle).group(1);
        RigidBody upper = pool.add(bar.at(0.5 * x, 0.5 * y).mass(2));
        RigidBody lower = pool.add(bar.at(1.5 * x, 1.5 * y).mass(1));
        pool.join(RevoluteJoint.at(JointScenes.hook(pool, 0, 0), upper, 0, 0));
        pool.join(RevoluteJoint.at(upper, lower, x, y));
        return lower;
    }

    /**
     * A disc on a rod that holds its centre, let go near the top: what may be missed is a share of
     * the rod, for there are no arms.
     */
    @Test
    void rodHoldsACentreWithoutDrift() {
        Pool pool = new Pool(JointScenes.EARTH, Accuracy.GAME);
        double angle = Math.toRadians(175);
        double x = Math.sin(angle);
        double y = -Math.cos(angle);
        RigidBody bob = pool.add(BodyDefinition.dynamic(new Circle(0.27)).at(x, y).group(1));
        Joint rod = pool.join(DistanceJoint.rod(JointScenes.hook(pool, 0, 0), 0, 0, bob, x, y));
        double start = pool.kineticEnergy() + pool.potentialEnergy();
        for (int i = 0; i < 600; i++) {
            pool.step(Scenes.DT);
            double energy = pool.kineticEnergy() + pool.potentialEnergy();
            assertThat(Math.abs(energy - start) / (bob.mass() * JointScenes.G)).isLessThan(1e-3);
            assertThat(rod.error()).isLessThan(1e-7);
        }
    }

    /** A pendulum swings alike on a hook and on a wide floor, whose centre is 1,000 m away. */
    @Test
    void whereAFixedBodyHasItsCentreDoesNotMatter() {
        double[] angles = new double[2];
        for (int i = 0; i < 2; i++) {
            Pool pool = new Pool(JointScenes.EARTH, Accuracy.GAME);
            BodyDefinition fixed = BodyDefinition.fixed(Polygon.box(0.1, 0.1)).at(1000 * i, 0);
            RigidBody bar = pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.1)).at(0.5, 0));
            Joint hinge = pool.join(RevoluteJoint.at(pool.add(fixed), bar, 0, 0));
            Scenes.run(pool, 600);
            angles[i] = hinge.angle();
        }
        assertThat(angles[1]).isCloseTo(angles[0], within(1e-7));
    }

    /** J13: a car at rest on a slope, braked by its rear wheel, by moments about either wheel. */
    @Test
    void carOnSpringsStandsByStatics() {
        Pool pool = new Pool(JointScenes.EARTH.with(new Friction()), Accuracy.GAME);
        double slope = 0.2;
        double cos = Math.cos(slope);
        double sin = Math.sin(slope);
        Material rubber = new Material(1, 2, 0);
        BodyDefinition hill = BodyDefinition.fixed(Polygon.box(100, 2)).at(sin, -cos);
        RigidBody ground = pool.add(hill.angle(slope).material(rubber));
        BodyDefinition body = BodyDefinition.dynamic(Polygon.box(2.2, 0.5)).group(1).angle(slope);
        BodyDefinition wheel = BodyDefinition.dynamic(new Circle(0.3)).group(1).angle(slope);
        RigidBody chassis = pool.add(body.at(-0.65 * sin, 0.65 * cos).mass(100));
        RigidBody back =
                pool.add(wheel.at(-cos - 0.3 * sin, -sin + 0.3 * cos).mass(1).material(rubber));
        RigidBody front =
                pool.add(wheel.at(cos - 0.3 * sin, sin + 0.3 * cos).mass(1).material(rubber));
        double up = slope + Math.PI / 2;
        JointDefinition rear = WheelJoint.at(chassis, back, back.x(), back.y(), up);
        pool.join(rear.spring(20, 1).motor(0, 1e4));
        pool.join(WheelJoint.at(chassis, front, front.x(), front.y(), up).spring(20, 1));
        Scenes.run(pool, 360);
        double moments = 0;
        for (RigidBody part : List.of(chassis, back, front)) {
            moments += part.mass() * JointScenes.G * (front.x() + 0.3 * sin - part.x());
        }
        double apart = Math.hypot(front.x() - back.x(), front.y() - back.y());
        assertThat(impulse(pool, back, ground) / Scenes.DT / (moments / apart))
                .isCloseTo(1, within(1e-4));
        double rest = 102 * JointScenes.G * cos - moments / apart;
        assertThat(impulse(pool, front, ground) / Scenes.DT / rest).isCloseTo(1, within(1e-4));
    }

    private static double impulse(Pool pool, RigidBody a, RigidBody b) {
        return pool.contactEvents().stream()
                .filter(e -> List.of(e.a(), e.b()).containsAll(List.of(a, b)))
                .mapToDouble(ContactEvent::impulse)
                .sum();
    }
}

package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;

/** Joints against closed forms: periods, statics, springs, motors, limits, couplings. */
class JointsTest {

    private static final double G = 9.81;
    private static final double DT = 1.0 / 60;
    private static final Effects SPACE = Effects.of(new Contacts(), new Rotation(), new Joints());
    private static final Effects EARTH = SPACE.with(new Gravity(0, -G));

    private static RigidBody ground(Pool pool) {
        return pool.add(BodyDefinition.fixed(Polygon.box(0.1, 0.1)));
    }

    @Test
    void areRefusedWhereTheyAreNotDeclared() {
        Pool pool = new Pool();
        RigidBody a = pool.add(BodyDefinition.dynamic(new Circle(1)));
        RigidBody b = pool.add(BodyDefinition.dynamic(new Circle(1)).at(3, 0));
        assertThatThrownBy(() -> pool.join(RevoluteJoint.at(a, b, 1, 0)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("Joints");
        assertThat(pool.joints()).isEmpty();
        assertThatThrownBy(pool::brokenJoints)
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("Pool.brokenJoints needs the effect Joints");
    }

    /**
     * T = 4·√(I/(m·g·d))·K(sin(α/2)), by the arithmetic-geometric mean; the limits are those of J1
     * and J2: a leapfrog errs (ωh)²/24 at GAME, the composition of order four by round-off.
     */
    @ParameterizedTest(name = "{1} rad at {0}")
    @CsvSource({
        "GAME, 0.0873, 1e-3", "GAME, 1.5708, 1e-3", "GAME, 3.0543, 1e-3",
        "EXACT, 0.0873, 1e-6", "EXACT, 1.5708, 1e-6", "EXACT, 3.0543, 1e-6"
    })
    void physicalPendulumSwingsAtItsPeriod(String preset, double amplitude, double limit) {
        Pool pool = new Pool(EARTH, JointScenes.accuracy(preset));
        double d = 0.5;
        double mass = 2;
        double inertia = 0.3;
        RigidBody bob =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.1, 1))
                                .at(d * Math.sin(amplitude), -d * Math.cos(amplitude))
                                .angle(amplitude)
                                .mass(mass)
                                .inertia(inertia));
        Joint hinge = pool.join(RevoluteJoint.at(ground(pool), bob, 0, 0));
        double about = inertia + mass * d * d;
        double truth =
                2 * Math.PI * Math.sqrt(about / (mass * G * d)) / mean(1, Math.cos(amplitude / 2));
        double start = JointScenes.energy(pool);
        double scale = mass * G * d * (1 - Math.cos(amplitude));
        double first = 0;
        double last = 0;
        int crossings = 0;
        while (crossings < 41) {
            double angle = bob.angle();
            double spin = bob.angularVelocity();
            double time = pool.time();
            pool.step(DT);
            if (angle * bob.angle() < 0) {
                last = time + DT * root(angle, spin * DT, bob.angle(), bob.angularVelocity() * DT);
                first = crossings == 0 ? last : first;
                crossings++;
            }
            assertThat(Math.abs(JointScenes.energy(pool) - start) / scale).isLessThan(limit);
            assertThat(hinge.error()).isLessThan(preset.equals("EXACT") ? 1e-9 : 1e-4);
        }
        assertThat((last - first) / 20 / truth).isCloseTo(1, within(limit));
    }

    private static double mean(double a, double b) {
        double x = a;
        double y = b;
        for (int i = 0; i < 20; i++) {
            double next = (x + y) / 2;
            y = Math.sqrt(x * y);
            x = next;
        }
        return x;
    }

    /** Where a cubic by its ends and slopes is 0, as a share of the step. */
    private static double root(double from, double slope, double to, double slopeTo) {
        double low = 0;
        double high = 1;
        for (int i = 0; i < 50; i++) {
            double s = (low + high) / 2;
            double value =
                    (1 + 2 * s) * (1 - s) * (1 - s) * from
                            + s * (1 - s) * (1 - s) * slope
                            + s * s * (3 - 2 * s) * to
                            - s * s * (1 - s) * slopeTo;
            if (value * from > 0) {
                low = s;
            } else {
                high = s;
            }
        }
        return low;
    }

    /** tan θₖ = (n + 1 − 2k)·w/(2H): each link in balance, so nothing moves but for round-off. */
    @ParameterizedTest
    @CsvSource({"GAME", "EXACT"})
    void chainInItsCatenaryStays(String preset) {
        Pool pool = new Pool(EARTH, JointScenes.accuracy(preset));
        RigidBody before = ground(pool);
        double horizontal = 100;
        int links = 50;
        double x = 0;
        double y = 0;
        for (int k = 1; k <= links; k++) {
            double angle = -Math.atan((links + 1 - 2 * k) * G / (2 * horizontal));
            double dx = 0.2 * Math.cos(angle);
            double dy = 0.2 * Math.sin(angle);
            RigidBody link =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(0.2, 0.05))
                                    .at(x + dx / 2, y + dy / 2)
                                    .angle(angle)
                                    .mass(1));
            pool.join(RevoluteJoint.at(before, link, x, y));
            before = link;
            x += dx;
            y += dy;
        }
        RigidBody end = pool.add(BodyDefinition.fixed(Polygon.box(0.1, 0.1)).at(x, y));
        Joint last = pool.join(RevoluteJoint.at(before, end, x, y));
        Scenes.run(pool, 120);
        double tension = Math.hypot(horizontal, links * G / 2);
        assertThat(last.reactionForce() / tension).isCloseTo(1, within(1e-9));
        assertThat(pool.kineticEnergy()).isLessThan(1e-15);
    }

    /** J5: ten thousand times a link's weight at the end of thirty links, let swing from 1 rad. */
    @ParameterizedTest
    @CsvSource({"GAME, 1e-6, 1e-3", "EXACT, 1e-9, 1e-6"})
    void chainCarriesAHeavyBob(String preset, double gap, double limit) {
        Pool pool = new Pool(EARTH, JointScenes.accuracy(preset));
        RigidBody before = ground(pool);
        double dx = 0.2 * Math.sin(1);
        double dy = -0.2 * Math.cos(1);
        for (int i = 0; i < 30; i++) {
            RigidBody link =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(0.05, 0.2))
                                    .at((i + 0.5) * dx, (i + 0.5) * dy)
                                    .angle(1)
                                    .mass(1)
                                    .group(1));
            pool.join(RevoluteJoint.at(before, link, i * dx, i * dy));
            before = link;
        }
        RigidBody bob =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.1))
                                .at(30 * dx, 30 * dy)
                                .mass(1e4)
                                .group(1));
        pool.join(RevoluteJoint.at(before, bob, bob.x(), bob.y()));
        double start = JointScenes.energy(pool);
        for (int i = 0; i < 90; i++) {
            pool.step(DT);
            assertThat(pool.joints()).allSatisfy(j -> assertThat(j.error()).isLessThan(gap));
            assertThat(Math.hypot(bob.x(), bob.y())).isLessThan(6 * (1 + limit));
            assertThat(Math.abs(JointScenes.energy(pool) - start)).isLessThan(limit * 1e4 * G * 6);
        }
    }

    /** ẍ + 2ζω·ẋ + ω²·x = 0, up to a quarter of the rate of steps; the limits are those of J8. */
    @ParameterizedTest(name = "{1} Hz, ζ = {2} at {0}")
    @CsvSource({
        "GAME, 2, 0, 1e-2", "GAME, 15, 0, 1e-2", "GAME, 15, 0.1, 1e-2",
        "EXACT, 2, 0, 1e-4", "EXACT, 15, 0, 1e-4", "EXACT, 15, 0.1, 1e-4"
    })
    void springSwingsAndDecays(String preset, double hertz, double ratio, double limit) {
        Pool pool = new Pool(SPACE, JointScenes.accuracy(preset));
        RigidBody body = pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(1, 0).mass(3));
        Joint slide =
                pool.join(PrismaticJoint.along(ground(pool), body, 1, 0, 0).spring(hertz, ratio));
        body.moveTo(1.2, 0, 0);
        double omega = 2 * Math.PI * hertz;
        double damped = omega * Math.sqrt(1 - ratio * ratio);
        int steps = (int) (2 * 60 / hertz) + 1;
        for (int i = 1; i <= steps; i++) {
            pool.step(DT);
            double t = i * DT;
            double truth =
                    0.2
                            * Math.exp(-ratio * omega * t)
                            * (Math.cos(damped * t)
                                    + ratio * omega / damped * Math.sin(damped * t));
            // A period off by a share is a phase off by that share of ω·t.
            double allowed = 0.2 * limit * Math.max(1, omega * t);
            assertThat(slide.translation()).isCloseTo(truth, within(allowed));
        }
    }

    /** At rest a spring of any stiffness is stretched by m·g/k. */
    @ParameterizedTest
    @CsvSource({"2", "200", "2000"})
    void springBearsItsLoad(double hertz) {
        Pool pool = new Pool(EARTH, Accuracy.GAME);
        RigidBody body = pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(0, -1).mass(2));
        JointSettings soft = JointSettings.NONE.spring(new JointSpring(hertz, 0.7));
        JointFrame centre = JointFrame.CENTRE;
        Joint spring = pool.join(new DistanceJoint(ground(pool), body, centre, centre, 1, soft));
        Scenes.run(pool, 600);
        double sag = 2 * G / spring.stiffness();
        assertThat((spring.translation() - 1) / sag).isCloseTo(1, within(1e-6));
        assertThat(spring.reactionForceY()).isCloseTo(2 * G, within(1e-6));
    }

    /** ω = τ·t/I up to the speed, which then holds. */
    @Test
    void motorDrivesUpToItsSpeed() {
        Pool pool = new Pool(SPACE, Accuracy.GAME);
        RigidBody wheel = pool.add(BodyDefinition.dynamic(new Circle(1)).mass(1).inertia(2));
        pool.join(RevoluteJoint.at(ground(pool), wheel, 0, 0).motor(3, 5));
        for (int i = 1; i <= 120; i++) {
            pool.step(DT);
            double truth = Math.min(3, 5.0 / 2 * i * DT);
            assertThat(wheel.angularVelocity()).isCloseTo(truth, within(1e-9));
        }
    }

    /** A bar that falls on its limit stops there, and its weight is the limit's to carry. */
    @Test
    void limitStopsWithoutPassing() {
        Pool pool = new Pool(EARTH, Accuracy.GAME);
        RigidBody bar = pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.1)).at(0.5, 0).mass(2));
        Joint hinge = pool.join(RevoluteJoint.at(ground(pool), bar, 0, 0).limits(-1, 1));
        for (int i = 0; i < 240; i++) {
            pool.step(DT);
            assertThat(hinge.angle()).isGreaterThan(-1 - 1e-4);
        }
        assertThat(hinge.angle()).isCloseTo(-1, within(1e-9));
        assertThat(hinge.reactionTorque()).isCloseTo(2 * G * 0.5 * Math.cos(1), within(1e-6));
    }

    /** Twenty welds: the wall carries the weight, and its moment about the wall. */
    @Test
    void cantileverCarriesItsMoment() {
        Pool pool = new Pool(EARTH, Accuracy.GAME);
        RigidBody before = ground(pool);
        for (int i = 0; i < 20; i++) {
            RigidBody piece =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(0.2, 0.1))
                                    .at(0.1 + 0.2 * i, 0)
                                    .mass(1));
            pool.join(WeldJoint.at(before, piece, 0.2 * i, 0));
            before = piece;
        }
        Scenes.run(pool, 60);
        Joint wall = pool.joints().get(0);
        assertThat(wall.reactionForce() / (20 * G)).isCloseTo(1, within(1e-9));
        assertThat(wall.reactionTorque() / (20 * G * 2)).isCloseTo(1, within(1e-9));
    }

    /** a = (m₁ − m₂)·g/(m₁ + m₂). */
    @Test
    void pulleyIsAtwoodsMachine() {
        Pool pool = new Pool(EARTH, Accuracy.GAME);
        RigidBody heavy = pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(-1, 0).mass(3));
        RigidBody light = pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(1, 0).mass(2));
        pool.join(PulleyJoint.over(heavy, light, 10));
        Scenes.run(pool, 60);
        assertThat(heavy.velocityY()).isCloseTo(-G / 5, within(1e-9));
        assertThat(light.velocityY()).isCloseTo(G / 5, within(1e-9));
    }

    /** α = τ/(I₁ + I₂/r²) of the first wheel, where the second turns by −1/r of it. */
    @Test
    void gearSharesItsTorque() {
        Pool pool = new Pool(SPACE, Accuracy.GAME);
        RigidBody frame = ground(pool);
        RigidBody one = pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(-1, 0).inertia(2));
        RigidBody two = pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(1, 0).inertia(3));
        Joint first = pool.join(RevoluteJoint.at(frame, one, -1, 0).motor(100, 5));
        Joint second = pool.join(RevoluteJoint.at(frame, two, 1, 0));
        pool.join(GearJoint.of(first, second, 2));
        Scenes.run(pool, 60);
        assertThat(one.angularVelocity()).isCloseTo(5 / (2 + 3.0 / 4), within(1e-9));
        assertThat(two.angularVelocity()).isCloseTo(-one.angularVelocity() / 2, within(1e-9));
    }

    /** A parallelogram with one leg too many, driven at 1 rad/s: the coupler goes in a circle. */
    @Test
    void redundantLoopNeitherLocksNorDrifts() {
        Pool pool = new Pool(SPACE, Accuracy.GAME);
        RigidBody frame = ground(pool);
        RigidBody coupler = pool.add(BodyDefinition.dynamic(Polygon.box(2, 0.1)).at(1, 1).group(1));
        for (int i = 0; i < 3; i++) {
            RigidBody leg =
                    pool.add(BodyDefinition.dynamic(Polygon.box(0.1, 1)).at(i, 0.5).group(1));
            JointDefinition foot = RevoluteJoint.at(frame, leg, i, 0);
            pool.join(i == 0 ? foot.motor(1, Double.POSITIVE_INFINITY) : foot);
            pool.join(RevoluteJoint.at(leg, coupler, i, 1));
        }
        for (int i = 1; i <= 60; i++) {
            pool.step(DT);
            assertThat(coupler.x()).isCloseTo(1 - Math.sin(i * DT), within(1e-9));
            assertThat(coupler.y()).isCloseTo(Math.cos(i * DT), within(1e-9));
        }
    }

    /** Two bodies on a rod in space keep momentum and angular momentum. */
    @Test
    void freeAssemblyKeepsItsMomenta() {
        Pool pool = new Pool(SPACE, Accuracy.GAME);
        RigidBody a = pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.2)).velocity(1, 3).spin(5));
        RigidBody b = pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.2)).at(1, 0).mass(7));
        pool.join(RevoluteJoint.at(a, b, 0.5, 0));
        pool.step(DT);
        double px = pool.momentumX();
        double py = pool.momentumY();
        double angular = pool.angularMomentum();
        Scenes.run(pool, 300);
        assertThat(pool.momentumX()).isCloseTo(px, within(1e-9));
        assertThat(pool.momentumY()).isCloseTo(py, within(1e-9));
        assertThat(pool.angularMomentum()).isCloseTo(angular, within(1e-7));
    }

    @Test
    void snapshotWithinASwingGoesOnToTheBit() {
        Pool pool = new Pool(EARTH, Accuracy.GAME);
        RigidBody bob = pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.1)).at(0.5, 0));
        pool.join(RevoluteJoint.at(ground(pool), bob, 0, 0).limits(-2, 1).motor(0, 0.1));
        Scenes.run(pool, 17);
        Pool again = Pool.restore(pool.snapshot());
        Scenes.run(pool, 60);
        Scenes.run(again, 60);
        assertThat(again.stateHash()).isEqualTo(pool.stateHash());
        assertThat(again.joints().get(0).definition().settings())
                .isEqualTo(pool.joints().get(0).definition().settings());
    }

    /** A rod breaks in the step in which it first carries more than it bears. */
    @Test
    void breaksAndTells() {
        Pool pool = new Pool(EARTH, Accuracy.GAME);
        RigidBody bob = pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(0, -1).mass(2));
        RigidBody hook = ground(pool);
        Joint holds =
                pool.join(DistanceJoint.rod(hook, 0, 0, bob, 0, -1).breaking(2 * G * 1.001, 1));
        Scenes.run(pool, 30);
        assertThat(holds.isAlive()).isTrue();
        holds.breaking(2 * G * 0.999, 1);
        pool.step(DT);
        assertThat(holds.isAlive()).isFalse();
        assertThat(pool.brokenJoints()).hasSize(1);
        assertThat(pool.brokenJoints().get(0).force()).isCloseTo(2 * G, within(1e-6));
        pool.step(DT);
        assertThat(pool.brokenJoints()).isEmpty();
        assertThat(bob.velocityY()).isCloseTo(-G * DT, within(1e-9));
    }

    @Test
    void goesWithItsBody() {
        Pool pool = new Pool(EARTH, Accuracy.GAME);
        RigidBody bob = pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(0, -1));
        RigidBody hook = ground(pool);
        Joint rod = pool.join(DistanceJoint.rod(hook, 0, 0, bob, 0, -1));
        assertThat(bob.joints()).containsExactly(rod);
        pool.remove(bob);
        assertThat(rod.isAlive()).isFalse();
        assertThat(hook.joints()).isEmpty();
        pool.step(DT);
    }
}

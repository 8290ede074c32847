package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Impacts on joined bodies, at limits and at the ends of ropes, against the law of impact. */
class JointImpactsTest {

    private static Material elastic(double elasticity) {
        return new Material(1000, 0, elasticity);
    }

    /**
     * J6: equals that lose nothing hand on their speed, one to the next at one instant. The limits
     * are those of J6: errors of second order cancel between the mirror images of a swing.
     */
    @ParameterizedTest
    @CsvSource({"GAME, 1e-2", "EXACT, 1e-6"})
    void cradleOnRodsHandsItsSwingOn(String preset, double limit) {
        Pool pool = new Pool(JointScenes.EARTH, JointScenes.accuracy(preset));
        List<RigidBody> discs = new ArrayList<>();
        double amplitude = 0.5;
        for (int i = 0; i < 5; i++) {
            double angle = i == 0 ? -amplitude : 0;
            double x = 0.2 * i + Math.sin(angle);
            double y = -Math.cos(angle);
            BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.1)).at(x, y);
            discs.add(pool.add(disc.material(elastic(1))));
            RigidBody hook = JointScenes.hook(pool, 0.2 * i, 0);
            pool.join(DistanceJoint.rod(hook, 0.2 * i, 0, discs.get(i), x, y));
        }
        double height = 1 - Math.cos(amplitude);
        double fastest = Math.sqrt(2 * JointScenes.G * height);
        int swings = 0;
        while (swings < 20) {
            RigidBody far = discs.get(swings % 2 == 0 ? 4 : 0);
            double before = far.velocityX();
            pool.step(Scenes.DT);
            assertThat(pool.time()).as("time of swing %d", swings).isLessThan(1.2 * (swings + 1));
            discs.subList(1, 4)
                    .forEach(d -> assertThat(speed(d) / fastest).as("others").isLessThan(limit));
            double rise = far.y() + 1 + speed(far) * speed(far) / (2 * JointScenes.G);
            if (rise > height / 2 && before * far.velocityX() <= 0 && before != 0) {
                assertThat(rise / height).as("swing %d", swings).isCloseTo(1, within(limit));
                swings++;
            }
        }
    }

    private static double speed(RigidBody body) {
        return Math.hypot(body.velocityX(), body.velocityY());
    }

    /**
     * J10: a bar falls on a limit of its hinge, and rises to e² of the height it fell by, once for
     * each rebound; the height is told by the energy. The limits are those of J10; a rise is known
     * to what the place of the impact is, over a height that shrinks by e² with each.
     */
    @ParameterizedTest(name = "e = {1} at {0}")
    @CsvSource({
        "GAME, 0, 1e-4", "GAME, 0.5, 1e-4", "GAME, 1, 1e-4",
        "EXACT, 0, 1e-9", "EXACT, 0.5, 1e-9", "EXACT, 1, 1e-9"
    })
    void limitReboundsByItsElasticity(String preset, double elasticity, double limit) {
        Pool pool = new Pool(JointScenes.EARTH, JointScenes.accuracy(preset));
        double lowest = -0.5;
        RigidBody bar = pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.1)).at(0.5, 0).mass(2));
        JointDefinition definition = RevoluteJoint.at(JointScenes.hook(pool, 0, 0), bar, 0, 0);
        Joint hinge = pool.join(definition.limits(lowest, 1, elasticity));
        double fallen = 0.5 * Math.sin(-lowest);
        int rebounds = 0;
        for (int i = 0; i < 120 && rebounds < 2; i++) {
            double before = bar.angularVelocity();
            pool.step(Scenes.DT);
            assertThat(hinge.angle()).isGreaterThan(lowest - limit);
            if (before > 0 && bar.angularVelocity() <= 0) {
                rebounds++;
                double energy = pool.kineticEnergy() + pool.potentialEnergy();
                double kept = (energy / (2 * JointScenes.G) + fallen) / fallen;
                double truth = Math.pow(elasticity, 2 * rebounds);
                assertThat(kept).as("rebound %d", rebounds).isCloseTo(truth, within(limit));
            }
        }
        assertThat(rebounds).isEqualTo(elasticity > 0 ? 2 : 0);
        if (elasticity == 0) {
            assertThat(hinge.angle()).isCloseTo(lowest, within(limit));
            double torque = 2 * JointScenes.G * 0.5 * Math.cos(lowest);
            assertThat(hinge.reactionTorque()).isCloseTo(torque, within(1e-6));
        }
    }

    /**
     * J11: two discs fly apart until their rope is taut. With u the speed along it then, J =
     * u/(1/m₁ + 1/m₂) makes it 0 and takes J·u/2 of the energy; what is across the rope stays, and
     * turns the two about each other.
     */
    @ParameterizedTest
    @CsvSource({"GAME, 1e-6", "EXACT, 1e-9"})
    void ropeThatTautensIsAnImpact(String preset, double limit) {
        Pool pool = new Pool(JointScenes.SPACE, JointScenes.accuracy(preset));
        RigidBody a = pool.add(BodyDefinition.dynamic(new Circle(0.1)).mass(2));
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.1)).at(0.5, 0.3).mass(3);
        RigidBody b = pool.add(disc.velocity(3, 1));
        Joint rope = pool.join(DistanceJoint.rope(a, 0, 0, b, 0.5, 0.3, 2));
        // (0.5 + 3·t)² + (0.3 + t)² = 2²
        double half = 0.5 * 3 + 0.3;
        double time = (-half + Math.sqrt(half * half + 10 * (4 - 0.25 - 0.09))) / 10;
        double nx = (0.5 + 3 * time) / 2;
        double ny = (0.3 + time) / 2;
        double along = 3 * nx + ny;
        double impulse = along / (1.0 / 2 + 1.0 / 3);
        Scenes.run(pool, 40);
        assertThat(pool.momentumX()).isCloseTo(9, within(1e-12));
        assertThat(pool.momentumY()).isCloseTo(3, within(1e-12));
        double kinetic = 3.0 / 2 * 10 - impulse * along / 2;
        assertThat(pool.kineticEnergy() / kinetic).isCloseTo(1, within(limit));
        double angle = Math.atan2(ny, nx) + (nx - 3 * ny) / 2 * (pool.time() - time);
        assertThat(Math.atan2(b.y() - a.y(), b.x() - a.x())).isCloseTo(angle, within(limit));
        assertThat(rope.error()).isLessThan(limit);
    }

    /** J11: m·(g·cos θ + v²/r) at the top of a turn that is just fast enough, and at its bottom. */
    @ParameterizedTest
    @CsvSource({"GAME, 1e-2", "EXACT, 1e-6"})
    void ropeCarriesATurn(String preset, double limit) {
        Pool pool = new Pool(JointScenes.EARTH, JointScenes.accuracy(preset));
        double v = 1.1 * Math.sqrt(5 * JointScenes.G);
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.1)).at(0, -1).mass(2);
        RigidBody bob = pool.add(disc.velocity(v, 0));
        Joint rope =
                pool.join(DistanceJoint.rope(JointScenes.hook(pool, 0, 0), 0, 0, bob, 0, -1, 1));
        for (int i = 0; i < 120; i++) {
            double gainedX = bob.velocityX();
            double gainedY = bob.velocityY();
            pool.step(Scenes.DT);
            double angle = Math.atan2(bob.x(), -bob.y());
            double truth = Math.sqrt(v * v - 2 * JointScenes.G * (1 - Math.cos(angle)));
            assertThat(speed(bob) / truth).isCloseTo(1, within(limit));
            // The mean of a force over a step is what it gave: 2·(Δv/dt + g).
            gainedX = 2 * (bob.velocityX() - gainedX) / Scenes.DT;
            gainedY = 2 * ((bob.velocityY() - gainedY) / Scenes.DT + JointScenes.G);
            assertThat(rope.reactionForceX()).isCloseTo(gainedX, within(1e-9 * v * v));
            assertThat(rope.reactionForceY()).isCloseTo(gainedY, within(1e-9 * v * v));
        }
    }

    /**
     * J17: a ball strikes the lower one of two bars in space on a hinge. Its speed follows from the
     * mass that both have together at the point struck: with x from the bar's centre, the hinge
     * hands on a share of the impulse, see the derivation within.
     */
    @ParameterizedTest(name = "e = {1} at {0}")
    @CsvSource({"GAME, 1, 1e-3", "EXACT, 1, 1e-9", "EXACT, 0.3, 1e-9"})
    void blowGoesThroughAFreeAssemblyAtOnce(String preset, double elasticity, double limit) {
        Pool pool = new Pool(JointScenes.SPACE, JointScenes.accuracy(preset));
        BodyDefinition bar = BodyDefinition.dynamic(Polygon.box(0.1, 1)).group(1);
        RigidBody upper = pool.add(bar.at(0, 0.5).mass(2));
        RigidBody lower = pool.add(bar.at(0, -0.5).mass(3).material(elastic(0)));
        pool.join(RevoluteJoint.at(upper, lower, 0, 0));
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.1)).at(-1, -0.7).mass(1);
        RigidBody ball = pool.add(disc.velocity(7, 0).material(elastic(elasticity)));
        double angular = pool.angularMomentum();
        double energy = pool.kineticEnergy();
        while (ball.velocityX() == 7) {
            pool.step(Scenes.DT);
            assertThat(pool.time()).isLessThan(0.2);
        }
        // At the hinge, x up: an impulse J along +x at 0.2 below the centre moves the lower end by
        // J·(1/m − 0.5·0.2/I); H holds both together there.
        double handed = 1 / lower.mass() - 0.5 * 0.2 / lower.inertia();
        double both =
                1 / upper.mass()
                        + 0.25 / upper.inertia()
                        + 1 / lower.mass()
                        + 0.25 / lower.inertia();
        double answer = 1 / lower.mass() + 0.04 / lower.inertia() - handed * handed / both;
        double impulse = (1 + elasticity) * 7 / (1 + answer);
        assertThat(ball.velocityX()).isCloseTo(7 - impulse, within(7 * limit));
        assertThat(pool.momentumX()).isCloseTo(7, within(7e-12));
        assertThat(pool.momentumY()).isCloseTo(0, within(7e-12));
        assertThat(pool.angularMomentum() / angular).isCloseTo(1, within(limit));
        assertThat(pool.kineticEnergy()).isLessThan(energy * (1 + limit));
    }

    /** J17: J = (1 + e)·v/(1/m + d²/I) about a hinge, which keeps the angular momentum about it. */
    @ParameterizedTest(name = "e = {1} at {0}")
    @CsvSource({"GAME, 1, 1e-3", "EXACT, 1, 1e-9", "EXACT, 0.6, 1e-9"})
    void blowTurnsAHungBarAboutItsHinge(String preset, double elasticity, double limit) {
        Pool pool = new Pool(JointScenes.SPACE, JointScenes.accuracy(preset));
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(0.2, 1)).at(0, -0.5).mass(4);
        RigidBody bar = pool.add(box.material(elastic(elasticity)));
        pool.join(RevoluteJoint.at(JointScenes.hook(pool, 0, 0), bar, 0, 0));
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.1)).at(-1, -0.7).mass(1);
        RigidBody ball = pool.add(disc.velocity(7, 0).material(elastic(0)));
        while (ball.velocityX() == 7) {
            pool.step(Scenes.DT);
            assertThat(pool.time()).isLessThan(0.2);
        }
        double inertia = bar.inertia() + 4 * 0.25;
        double impulse = (1 + elasticity) * 7 / (1 + 0.49 / inertia);
        assertThat(ball.velocityX()).isCloseTo(7 - impulse, within(7 * limit));
        assertThat(bar.angularVelocity()).isCloseTo(0.7 * impulse / inertia, within(7 * limit));
    }

    /**
     * Velocities that are given to what lies on its limit are an impact, too: a slide that is
     * pushed against its end at 2 m/s comes back at e times that.
     */
    @Test
    void whatIsPushedAgainstItsLimitRebounds() {
        Pool pool = new Pool(JointScenes.SPACE, Accuracy.GAME);
        RigidBody body = pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(1, 0).mass(3));
        pool.join(
                PrismaticJoint.along(JointScenes.hook(pool, 0, 0), body, 1, 0, 0)
                        .limits(0, 1, 0.25));
        body.velocity(-2, 0);
        pool.step(Scenes.DT);
        assertThat(body.velocityX()).isCloseTo(0.5, within(1e-12));
        assertThat(body.x()).isCloseTo(1 + 0.5 * Scenes.DT, within(1e-12));
    }

    /**
     * A body that rattles between two elastic limits keeps its speed, however short the distance.
     */
    @Test
    void rattlesBetweenLimitsWithoutGain() {
        Pool pool = new Pool(JointScenes.SPACE, Accuracy.GAME);
        RigidBody body = pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(1, 0).mass(3));
        JointDefinition slide = PrismaticJoint.along(JointScenes.hook(pool, 0, 0), body, 1, 0, 0);
        Joint joint = pool.join(slide.limits(-0.01, 0.01, 1));
        body.velocity(5, 0);
        for (int i = 0; i < 60; i++) {
            pool.step(Scenes.DT);
            assertThat(Math.abs(body.velocityX())).isCloseTo(5, within(1e-9));
            assertThat(Math.abs(joint.translation())).isLessThan(0.01 + 1e-5);
        }
    }

    /** A hit of a joined body is told once, with the speed at which the two came together. */
    @Test
    void hitsOfJoinedBodiesAreTold() {
        Pool pool = new Pool(JointScenes.EARTH, Accuracy.GAME);
        RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 1)).at(-0.2, -1));
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.1)).at(1, 0).mass(1);
        RigidBody bob = pool.add(disc.material(elastic(0.5)));
        pool.join(RevoluteJoint.at(JointScenes.hook(pool, 0, 0), bob, 0, 0));
        List<HitEvent> hits = new ArrayList<>();
        for (int i = 0; i < 60 && hits.isEmpty(); i++) {
            pool.step(Scenes.DT);
            hits.addAll(pool.hits());
        }
        assertThat(hits).hasSize(1);
        assertThat(List.of(hits.get(0).a(), hits.get(0).b())).containsExactlyInAnyOrder(wall, bob);
        // ½·(m + I/r²)·v² = m·g·r: it hangs straight down where it strikes.
        double effective = 1 + bob.inertia();
        assertThat(hits.get(0).speed())
                .isCloseTo(Math.sqrt(2 * JointScenes.G / effective), within(1e-3));
    }

    /**
     * A capsule on a slack rope lands nearly upright, with one end in reach of the floor and then
     * both. Its lowest point, h/2·|sin θ| + r below its centre, stays above the floor but for the
     * gap that counts as touching, 1e-4 of its width of 2·r.
     */
    @Test
    void capsuleOnASlackRopeLandsOnItsEnd() {
        SplittableRandom random = new SplittableRandom(3);
        int landed = 0;
        for (int i = 0; i < 100; i++) {
            Pool pool = new Pool(JointScenes.EARTH, Accuracy.GAME);
            pool.add(BodyDefinition.fixed(Polygon.box(40, 2)).at(0, -1).material(elastic(0)));
            double half = 0.2 + 0.3 * random.nextDouble();
            double height = 2 + random.nextDouble();
            RigidBody capsule =
                    pool.add(
                            BodyDefinition.dynamic(new Capsule(half, 0.6 * half))
                                    .at(0, height)
                                    .angle(Math.PI / 2 + 0.6 * random.nextDouble() - 0.3)
                                    .velocity(0, -10 * random.nextDouble())
                                    .spin(4 * random.nextDouble() - 2)
                                    .material(elastic(0)));
            RigidBody weight = pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(1, height + 2));
            pool.join(DistanceJoint.rope(capsule, 0, height, weight, 1, height + 2, 6));
            for (int step = 0; step < 60; step++) {
                pool.step(Scenes.DT);
                double low = half * Math.abs(Math.sin(capsule.angle())) + 0.6 * half;
                assertThat(capsule.y() - low).as("draw " + i).isGreaterThan(-1.2e-4 * half);
            }
            landed += capsule.y() < 2 * half ? 1 : 0;
        }
        assertThat(landed).isGreaterThan(90);
    }
}

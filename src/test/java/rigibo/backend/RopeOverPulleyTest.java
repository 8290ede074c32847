package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * A chain of light links lies over a fixed disc, with 1 kg at one end and more at the other. By
 * Euler's law friction holds it as long as the one is at most e^(μπ) times the other, 2.57 with μ =
 * 0.3: each link is pressed on by the tension times the angle by which the chain turns there.
 */
@Execution(ExecutionMode.CONCURRENT)
class RopeOverPulleyTest {

    private static final double FRICTION = 0.3;
    private static final double THICKNESS = 0.1;
    private static final int HANGING = 8;
    private static final double GRAVITY = 9.81;
    private static final double MOST_ASTRAY = 0.06;

    /** The largest error of a joint at GAME, m. */
    private static final double LIMIT_OF_JOINTS = 1e-4;

    /** Overlap that counts as none: 0.02 widths, in m. */
    private static final double MOST_OVERLAP = 0.02 * THICKNESS;

    private final Pool pool;
    private RigidBody first;
    private RigidBody last;

    RopeOverPulleyTest() {
        pool = new Pool(Effects.usual().without(Sleep.class).with(new Joints()), Accuracy.GAME);
    }

    /** Links so long that each touches the disc, of 1 m, at its middle. */
    private void lay(int links, double mass) {
        Material dry = Material.DEFAULT.friction(FRICTION).elasticity(0);
        pool.add(BodyDefinition.fixed(new Circle(1)).material(dry));
        double half = Math.PI / 2 / links;
        double radius = (1 + THICKNESS / 2) / Math.cos(half);
        double length = 2 * radius * Math.sin(half);
        int all = links + 2 * HANGING;
        double[] x = new double[all + 1];
        double[] y = new double[all + 1];
        for (int i = 0; i <= all; i++) {
            int onDisc = Math.max(0, Math.min(links, i - HANGING));
            double below = Math.max(0, Math.max(HANGING - i, i - HANGING - links));
            double angle = Math.PI - 2 * half * onDisc;
            x[i] = radius * Math.cos(angle);
            y[i] = radius * Math.sin(angle) - length * below;
        }
        for (int i = 0; i < all; i++) {
            RigidBody link =
                    pool.add(
                            BodyDefinition.dynamic(new Capsule(length / 2, THICKNESS / 2))
                                    .at((x[i] + x[i + 1]) / 2, (y[i] + y[i + 1]) / 2)
                                    .angle(Math.atan2(y[i + 1] - y[i], x[i + 1] - x[i]))
                                    .mass(mass)
                                    .material(dry)
                                    .group(1));
            if (last == null) {
                first = link;
            } else {
                pool.join(RevoluteJoint.at(last, link, x[i], y[i]));
            }
            last = link;
        }
        first = hang(first, x[0], y[0], 1);
    }

    private RigidBody hang(RigidBody link, double x, double y, double mass) {
        RigidBody weight =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                .at(x, y - 0.25)
                                .mass(mass)
                                .group(1));
        pool.join(RevoluteJoint.at(link, weight, x, y));
        return weight;
    }

    /**
     * How far a mass sinks at the heavy end, m, in a number of steps in which no joint is off by as
     * much as a length in m.
     */
    private double sinks(double mass, int steps, double mostOff) {
        double end = last.worldY(last.shape().boundingRadius() - THICKNESS / 2, 0);
        double endX = last.worldX(last.shape().boundingRadius() - THICKNESS / 2, 0);
        RigidBody weight = hang(last, endX, end, mass);
        double before = weight.y();
        for (int i = 0; i < steps; i++) {
            StepReport report = pool.step(Scenes.DT);
            assertThat(report.deepestOverlap()).isLessThan(MOST_OVERLAP);
            for (Joint joint : pool.joints()) {
                assertThat(joint.error()).isLessThan(mostOff);
            }
        }
        return before - weight.y();
    }

    /**
     * What friction holds stays, to a tenth of the tolerance of 0.1 mm: it may take up the load by
     * turning links, but not creep.
     */
    @ParameterizedTest
    @CsvSource({
        "12, 0.01, 1", "12, 0.01, 2.2", "12, 0.03, 2.2", "20, 0.003, 2.2", "20, 0.01, 1.8",
        "20, 0.03, 2.2", "32, 0.01, 1", "32, 0.01, 2.2", "32, 0.03, 1.8", "32, 0.03, 2.2",
    })
    void frictionHoldsWhatEulerSays(int links, double massOfLink, double mass) {
        lay(links, massOfLink);
        assertThat(Math.abs(sinks(mass, 60, 1e-5))).isLessThan(1e-5);
    }

    /**
     * What it does not hold slides as a rope does of the same weight: along it the tension grows by
     * dT/dφ = μ·(T + λ·r·g·sin φ) + λ·r·(g·cos φ + a), from m₁·(g + a) to m₂·(g − a). Of the links
     * at both ends of the arc one each may have left the disc, so that the rope touches along π or
     * 2π/n less. Friction at GAME may err by some hundredths of the load: 6 cm.
     */
    @ParameterizedTest
    @CsvSource({
        "12, 0.01, 3.5",
        "12, 0.03, 3.5",
        "20, 0.01, 3.5",
        "20, 0.03, 3.5",
        "20, 0.03, 4.5",
        "32, 0.01, 3.5",
        "32, 0.03, 3.5",
        "32, 0.03, 4.5",
    })
    void whatFrictionDoesNotHoldSlides(int links, double massOfLink, double mass) {
        lay(links, massOfLink);
        double least = slides(links, massOfLink, mass, Math.PI);
        double most = slides(links, massOfLink, mass, Math.PI - 2 * Math.PI / links);
        assertThat(sinks(mass, 60, LIMIT_OF_JOINTS))
                .isBetween(least - MOST_ASTRAY, most + MOST_ASTRAY);
    }

    /** How far the rope slides in a second, m. */
    private static double slides(int links, double massOfLink, double mass, double wrap) {
        double radius = 1 + THICKNESS / 2;
        double perMetre = massOfLink * links / (Math.PI * radius);
        double hanging = HANGING * massOfLink;
        double way = 0;
        double speed = 0;
        double dt = 1e-3;
        for (int i = 0; i < 1000; i++) {
            double light = 1 + hanging - perMetre * way;
            double heavy = mass + hanging + perMetre * way;
            double atRest = tension(light, perMetre * radius, wrap, 0);
            double more = tension(light, perMetre * radius, wrap, 1) - atRest;
            double acceleration = (heavy * GRAVITY - atRest) / (heavy + more);
            speed = Math.max(0, speed + dt * acceleration);
            way += dt * speed;
        }
        return way;
    }

    /** Tension at the heavier end if the rope slides with an acceleration, N. */
    private static double tension(double light, double perRadian, double wrap, double a) {
        int pieces = 400;
        double tension = light * (GRAVITY + a);
        for (int i = 0; i < pieces; i++) {
            double angle = (Math.PI - wrap) / 2 + (i + 0.5) * wrap / pieces;
            double pressed = tension + perRadian * GRAVITY * Math.sin(angle);
            double pulled = perRadian * (GRAVITY * Math.cos(angle) + a);
            tension += (FRICTION * pressed + pulled) * wrap / pieces;
        }
        return tension;
    }
}

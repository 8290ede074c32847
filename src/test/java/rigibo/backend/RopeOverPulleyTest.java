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

    private double sinks(double mass, int steps) {
        double end = last.worldY(last.shape().boundingRadius() - THICKNESS / 2, 0);
        double endX = last.worldX(last.shape().boundingRadius() - THICKNESS / 2, 0);
        RigidBody weight = hang(last, endX, end, mass);
        double before = weight.y();
        for (int i = 0; i < steps; i++) {
            StepReport report = pool.step(Scenes.DT);
            assertThat(report.deepestOverlap()).isLessThan(MOST_OVERLAP);
            for (Joint joint : pool.joints()) {
                assertThat(joint.error()).isLessThan(1e-5);
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
        assertThat(Math.abs(sinks(mass, 60))).isLessThan(1e-5);
    }

    /**
     * What it does not hold slides. A rope without mass would give the heavier one 1.5 m/s², 0.75 m
     * in a second; one whose links weigh up to a kilogram in all is slower, but goes.
     */
    @ParameterizedTest
    @CsvSource({"12, 0.01", "12, 0.03", "20, 0.01", "20, 0.03", "32, 0.01", "32, 0.03"})
    void whatFrictionDoesNotHoldSlides(int links, double massOfLink) {
        lay(links, massOfLink);
        assertThat(sinks(3.5, 60)).isBetween(0.2, 0.76);
    }
}

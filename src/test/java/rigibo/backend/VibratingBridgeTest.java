package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Outline;

import java.util.ArrayList;
import java.util.List;

/**
 * A heavy disc rolls along a bridge of planks and makes it tremble, so that it flies above them for
 * a step or two again and again, while they swing up to it.
 */
@Execution(ExecutionMode.CONCURRENT)
class VibratingBridgeTest {

    private static final int PLANKS = 24;

    private static final double GRAVITY = 9.81;

    /** As everywhere: the deepest overlap, in widths of the thinner body. */
    private static final double OVERLAP = 0.02;

    /** As everywhere: the energy gained in a step, as a share of what could be released. */
    private static final double GAINED = 1e-3;

    private static final double GAINED_AT_EXACT = 1e-6;

    @ParameterizedTest
    @CsvSource({
        "GAME, 0.6, 0.44",
        "GAME, 0.5, 0.4",
        "GAME, 0.4, 0.3",
        "EXACT, 0.5, 0.4",
        "EXACT, 0.4, 0.3",
    })
    void planksThatSwingDoNotGetIntoWhatFliesAboveThem(
            String accuracy, double length, double radius) {
        boolean isExact = accuracy.equals("EXACT");
        Pool pool =
                new Pool(
                        Effects.usual().with(new Joints()),
                        isExact ? Accuracy.EXACT : Accuracy.GAME);
        List<RigidBody> planks = bridge(pool, length);
        RigidBody first = planks.get(2);
        double up = length / 10 + radius;
        RigidBody disc =
                pool.add(
                        BodyDefinition.dynamic(new Circle(radius))
                                .at(first.worldX(0, up), first.worldY(0, up))
                                .material(new Material(1, 1, 0)));
        int flights = 0;
        double width = Math.min(2 * radius, length / 5);
        double energy = energy(pool);
        double most = (isExact ? GAINED_AT_EXACT : GAINED) * released(pool);
        for (int step = 0; step < 420; step++) {
            pool.step(1 / 60.0);
            double before = energy;
            energy = energy(pool);
            assertThat(energy - before).as("gained in step " + step).isLessThan(most);
            double deepest = deepest(disc, planks) / width;
            flights += deepest < 0 ? 1 : 0;
            assertThat(deepest).as("step " + step).isLessThan(OVERLAP);
        }
        assertThat(flights).isGreaterThan(10);
    }

    private static double energy(Pool pool) {
        return pool.kineticEnergy() + pool.potentialEnergy();
    }

    /** The energy of a fall of all bodies to the lowest point of any, J. */
    private static double released(Pool pool) {
        double lowest = Double.POSITIVE_INFINITY;
        double mass = 0;
        for (RigidBody body : pool.bodies()) {
            if (body.type() == BodyType.DYNAMIC) {
                lowest = Math.min(lowest, body.y() - body.shape().boundingRadius());
                mass += body.mass();
            }
        }
        return energy(pool) - mass * GRAVITY * lowest;
    }

    /**
     * Planks in balance: the slope of each is the weight on one side of it over twice the whole.
     */
    private static List<RigidBody> bridge(Pool pool, double length) {
        List<RigidBody> planks = new ArrayList<>();
        RigidBody before = hook(pool, 0, 0);
        double x = 0;
        double y = 0;
        for (int i = 0; i < PLANKS; i++) {
            double angle = StrictMath.atan((i + 0.5 - PLANKS / 2.0) / (2 * PLANKS));
            double dx = length * StrictMath.cos(angle);
            double dy = length * StrictMath.sin(angle);
            RigidBody plank =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(length, length / 5))
                                    .at(x + dx / 2, y + dy / 2)
                                    .angle(angle)
                                    .material(new Material(1, 1, 0)));
            pool.join(RevoluteJoint.at(before, plank, x, y));
            planks.add(plank);
            before = plank;
            x += dx;
            y += dy;
        }
        pool.join(RevoluteJoint.at(before, hook(pool, x, y), x, y));
        return planks;
    }

    private static RigidBody hook(Pool pool, double x, double y) {
        return pool.add(BodyDefinition.fixed(new Circle(0.01)).at(x, y).filter(Filter.ALL.mask(0)));
    }

    private static double deepest(RigidBody disc, List<RigidBody> planks) {
        Outline round = placed(disc);
        double deepest = Double.NEGATIVE_INFINITY;
        for (RigidBody plank : planks) {
            deepest = Math.max(deepest, -round.separation(placed(plank)));
        }
        return deepest;
    }

    private static Outline placed(RigidBody body) {
        Outline outline = new Outline(body.shape());
        outline.place(body.x(), body.y(), body.angle());
        return outline;
    }
}

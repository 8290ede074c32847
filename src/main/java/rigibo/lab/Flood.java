package rigibo.lab;

import rigibo.backend.Pool;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A flood: discs of elasticity 0.5 above a trough, without sleep, at {@code GAME}.
 *
 * @param width of the trough, m
 * @param radius of a disc, m
 */
public record Flood(double width, double radius) {

    /** The time step, s. */
    public static final double STEP = 1.0 / 60;

    /** The effects of the game's flood without friction. */
    public static final Effects FRICTIONLESS =
            Effects.of(
                    new Gravity(0, -9.81),
                    new Contacts(),
                    new Restitution(),
                    new ContinuousImpacts());

    /** The distance between discs at the start, in radii. */
    private static final double COLUMN = 2.6;

    private static final double ROW = 2.4;
    private static final double JITTER = 0.4;

    /** A pool with discs that are about to fall. */
    Pool pour(int bodies, Effects effects, double friction) {
        Pool pool = new Pool(effects, Accuracy.GAME);
        bodies(bodies, friction).forEach(pool::add);
        return pool;
    }

    /** The trough, three bodies, and a number of discs above it, all of one friction. */
    public List<BodyDefinition> bodies(int discs, double friction) {
        List<BodyDefinition> bodies = new ArrayList<>();
        Material stone = new Material(1, friction, 0);
        bodies.add(BodyDefinition.fixed(Polygon.box(width + 2, 1)).at(0, -0.5).material(stone));
        for (double x : new double[] {-width / 2 - 0.5, width / 2 + 0.5}) {
            bodies.add(BodyDefinition.fixed(Polygon.box(1, 400)).at(x, 199).material(stone));
        }
        SplittableRandom random = new SplittableRandom(1);
        Material drop = new Material(1, friction, 0.5);
        int columns = (int) ((width - 2 * radius) / (COLUMN * radius));
        for (int i = 0; i < discs; i++) {
            double x = 2 + (i % columns) * COLUMN + JITTER * random.nextDouble();
            double y = 4 + (i / columns) * ROW;
            bodies.add(
                    BodyDefinition.dynamic(new Circle(radius))
                            .at(x * radius - width / 2, y * radius)
                            .material(drop));
        }
        return bodies;
    }
}

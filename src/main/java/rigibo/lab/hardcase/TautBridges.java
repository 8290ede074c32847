package rigibo.lab.hardcase;

import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * J12/taut: planks hinged in a row as long as its span, onto which discs and boxes fall. A straight
 * row cannot carry a load by any finite force, and any sag makes it longer than its span. So
 * tension has no truth here, but the bridge must stay straight. Where n hinges come apart by e
 * each, the row is longer by n·e, and its middle leaves the line by at most s² = ((L + n·e)/2)² −
 * (L/2)², which is L·n·e/2 up to (n·e)²/4. Falling bodies are a tenth to ten times as heavy as a
 * plank.
 *
 * <p>Hinges may come apart by as much as impacts may miss their time, a millimetre at DRAFT and a
 * tenth of it at GAME, and by 1e-9 m at EXACT, the limit of all joints.
 */
final class TautBridges {

    private static final Limits ERROR = new Limits(1e-3, 1e-4, 1e-9);

    private static final double PLANK = 0.5;
    private static final double HEIGHT = 0.125;

    /** Height of a bridge above the one below, m. */
    private static final double ABOVE = 8;

    private static final double HORIZON = 3;
    private static final Material STUFF = Solid.matter(0.5, 0);

    private final WatchedPool pool;
    private final int planks;
    private final double y;
    private final List<RigidBody> row = new ArrayList<>();

    private TautBridges(WatchedPool pool, int planks, double y) {
        this.pool = pool;
        this.planks = planks;
        this.y = y;
    }

    static void fallOnAll(Trial trial) {
        int most = trial.sampling().count(2, 5);
        for (SplittableRandom random : trial.sampling().draws(3, 15)) {
            int bridges = 1 + random.nextInt(most);
            int planks = 10 + random.nextInt(51);
            double heavier = Math.pow(10, 2 * random.nextDouble() - 1);
            trial.variant(bridges + " of " + planks + " planks under " + heavier + " of one each");
            WatchedPool pool = trial.jointedEarth().withOverlapOfItsOwn();
            List<TautBridges> all = new ArrayList<>();
            for (int k = 0; k < bridges; k++) {
                TautBridges bridge = new TautBridges(pool, planks, k * ABOVE);
                bridge.lay();
                bridge.dropThings(random, heavier);
                all.add(bridge);
            }
            while (pool.time() < HORIZON) {
                pool.step();
                trial.measure("error of joints", pool.jointError(), "m", ERROR);
                all.forEach(bridge -> bridge.measure(trial));
            }
            trial.report("overlap of what fell", pool.deepestShare(), "width");
        }
    }

    private double length() {
        return PLANK * planks;
    }

    private void lay() {
        RigidBody before = pool.hook(0, y);
        for (int i = 0; i < planks; i++) {
            RigidBody plank =
                    pool.add(Solid.box(PLANK, HEIGHT).at((i + 0.5) * PLANK, y).material(STUFF));
            pool.join(RevoluteJoint.at(before, plank, i * PLANK, y));
            row.add(plank);
            before = plank;
        }
        RigidBody end = pool.hook(length(), y);
        pool.join(RevoluteJoint.at(before, end, length(), y));
    }

    /** Discs and boxes in turn over the middle half, a metre apart at least. */
    private void dropThings(SplittableRandom random, double heavier) {
        int count = Math.max(2, planks / 4);
        double mass = heavier * row.get(0).mass();
        for (int i = 0; i < count; i++) {
            double width = 0.2 + 0.3 * random.nextDouble();
            boolean isDisc = i % 2 == 0;
            Shape shape = isDisc ? new Circle(width / 2) : Polygon.box(width, width);
            pool.add(
                    BodyDefinition.dynamic(shape)
                            .at(length() * (0.25 + 0.5 * (i + 0.5) / count), y + drop(random))
                            .angle(random.nextDouble())
                            .mass(mass)
                            .material(STUFF));
        }
    }

    private static double drop(SplittableRandom random) {
        return 0.5 + 1.5 * random.nextDouble();
    }

    private void measure(Trial trial) {
        double longer = (planks + 1) * ERROR.of(trial.preset());
        double most = Math.sqrt(longer * (2 * length() + longer)) / 2;
        double farthest = 0;
        for (RigidBody plank : row) {
            farthest = Math.max(farthest, Math.abs(plank.y() - y));
        }
        trial.measure("off the line", farthest / most, "of what joints allow", 1);
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * Truth: light bodies carry heavy ones. Nothing moves, so after 2 s no overlap exceeds 2 L and no
 * body was pushed out. Ratios up to 100 are promised from GAME on, 1,000 and the large box from
 * FINE on, 10,000 at EXACT.
 */
final class HeavyOnLight implements Scenes {

    private static final double HORIZON = 2;
    private static final double LIMIT = 2 * Trial.TOLERATED_OVERLAP;

    @Override
    public void run(Trial trial) {
        int preset = trial.preset().ordinal();
        double most = Math.pow(10, preset + 1);
        for (double ratio = 10; ratio <= most; ratio *= 10) {
            trial.variant("two boxes, 1:" + (int) ratio);
            twoBoxes(trial, ratio);
        }
        boolean isFine = preset >= Preset.FINE.ordinal();
        for (int ratio = 100; ratio <= (isFine ? 300 : 100); ratio += 100) {
            trial.variant("pyramid under " + ratio);
            cappedPyramid(trial, ratio);
        }
        if (isFine) {
            trial.variant("20 × 20 on two boxes");
            large(trial, Polygon.box(1, 1), 0.5);
            trial.variant("20 × 20 on two triangles");
            large(trial, Polygon.of(-1, 0, 1, 0, 0, 1), 1.0 / 3);
        }
    }

    private static void twoBoxes(Trial trial, double ratio) {
        WatchedPool pool = trial.ground(0.6, 0);
        RigidBody light = pool.add(box(1).at(0, 0.5));
        pool.add(box(ratio).at(0, 1.5));
        judge(trial, pool, List.of(light));
    }

    private static void cappedPyramid(Trial trial, double ratio) {
        int base = 5;
        WatchedPool pool = trial.ground(0.6, 0);
        List<RigidBody> light = Solid.pyramid(box(1), base, 1, 0).map(pool::add).toList();
        pool.add(box(ratio).at(0, base + 0.5));
        judge(trial, pool, light);
    }

    /** A box with 400 times the area of each box below it falls by 1 cm. */
    private static void large(Trial trial, Shape support, double centre) {
        WatchedPool pool = trial.ground(0.6, 0);
        BodyDefinition post = Solid.of(support, 0.6, 0);
        List<RigidBody> light =
                List.of(pool.add(post.at(-9, centre)), pool.add(post.at(9, centre)));
        pool.add(Solid.box(20, 20, 0.6, 0).at(0, 11.01));
        judge(trial, pool, light);
    }

    private static BodyDefinition box(double density) {
        return Solid.box(1, 1).material(new Material(density, 0.6, 0));
    }

    private static void judge(Trial trial, WatchedPool pool, List<RigidBody> light) {
        Places starts = new Places(light);
        pool.run(HORIZON);
        trial.measure("overlap at rest", pool.overlapNow(), "width", LIMIT);
        trial.measure("pushed out", starts.farthest(), "m", 0.05);
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * A half ring of seventeen wedge stones on the floor, with four planks on its keystone, μ = 0.6.
 * Truth: a half ring stands by its own weight if its thickness exceeds 0.107 of its radius (J.
 * Heyman, The masonry arch, 1982); here it is 0.26. Nothing moves except that the joints settle.
 */
final class Arch implements Scenes {

    private static final int STONES = 17;
    private static final int PLANKS = 4;
    private static final double INNER = 5;
    private static final double OUTER = 6.5;
    private static final double PLANK = 0.25;
    private static final double HORIZON = 30;
    private static final double SETTLING = 0.01;

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.ground(0.6, 0);
        List<RigidBody> stones = new ArrayList<>();
        for (int i = 0; i < STONES; i++) {
            stones.add(pool.add(stone(Math.PI * i / STONES, Math.PI * (i + 1) / STONES)));
        }
        double top = OUTER * Math.cos(Math.PI / 2 / STONES);
        for (int i = 0; i < PLANKS; i++) {
            stones.add(pool.add(Solid.box(1, PLANK, 0.6, 0).at(0, top + (i + 0.5) * PLANK)));
        }
        Places starts = new Places(stones);
        pool.run(HORIZON);
        trial.measure("moved in 30 s", starts.farthest(), "m", SETTLING);
        double limit = 2 * Trial.TOLERATED_OVERLAP;
        trial.measure("overlap at rest", pool.overlapNow(), "width", limit);
    }

    private static BodyDefinition stone(double from, double to) {
        double[] xy = {
            INNER * Math.cos(from), INNER * Math.sin(from),
            OUTER * Math.cos(from), OUTER * Math.sin(from),
            OUTER * Math.cos(to), OUTER * Math.sin(to),
            INNER * Math.cos(to), INNER * Math.sin(to)
        };
        Polygon wedge = Polygon.of(xy);
        // A polygon keeps its corners relative to its centre of mass.
        return Solid.of(wedge, 0.6, 0).at(xy[0] - wedge.cornerX(0), xy[1] - wedge.cornerY(0));
    }
}

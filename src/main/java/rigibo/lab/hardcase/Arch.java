package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * A half ring of seventeen wedge stones on the floor, with four planks on its keystone, μ = 0.6.
 * Truth: a half ring stands by its own weight where its thickness is above 0.107 of its radius (J.
 * Heyman, The masonry arch, 1982); here it is 0.26. Nothing moves but for the joints' settling.
 */
final class Arch implements HardCase {

    private static final int STONES = 17;
    private static final int PLANKS = 4;
    private static final double INNER = 5;
    private static final double OUTER = 6.5;
    private static final double PLANK = 0.25;
    private static final double HORIZON = 30;
    private static final double SETTLING = 0.01;

    @Override
    public String row() {
        return "60/arch";
    }

    @Override
    public String title() {
        return "an arch of stones stands by its own weight";
    }

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.pool(Surroundings.earth());
        pool.add(Surroundings.floor(0.6, 0));
        List<RigidBody> stones = new ArrayList<>();
        for (int i = 0; i < STONES; i++) {
            stones.add(pool.add(stone(Math.PI * i / STONES, Math.PI * (i + 1) / STONES)));
        }
        double top = OUTER * Math.cos(Math.PI / 2 / STONES);
        for (int i = 0; i < PLANKS; i++) {
            stones.add(
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(1, PLANK))
                                    .at(0, top + (i + 0.5) * PLANK)
                                    .material(Surroundings.matter(0.6, 0))));
        }
        List<double[]> starts = new ArrayList<>();
        stones.forEach(stone -> starts.add(new double[] {stone.x(), stone.y()}));
        pool.run(HORIZON);
        for (int i = 0; i < stones.size(); i++) {
            double dx = stones.get(i).x() - starts.get(i)[0];
            double dy = stones.get(i).y() - starts.get(i)[1];
            trial.measure("moved in 30 s", Math.hypot(dx, dy), "m", SETTLING);
        }
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
        return BodyDefinition.dynamic(wedge)
                .at(xy[0] - wedge.cornerX(0), xy[1] - wedge.cornerY(0))
                .material(Surroundings.matter(0.6, 0));
    }
}

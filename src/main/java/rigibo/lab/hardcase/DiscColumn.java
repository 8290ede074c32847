package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * Truth: a straight column of discs is an unstable equilibrium. As it is symmetric, only round-off
 * can tip it, which takes longer than 10 s to grow. With e = 0.8 and gaps between the discs energy
 * never rises, an invariant of every case.
 */
final class DiscColumn implements Scenes {

    private static final int COUNT = 5;
    private static final double HORIZON = 10;
    private static final double[] DENSITIES = {1, 5, 9, 13, 1};

    @Override
    public void run(Trial trial) {
        trial.variant("e 0");
        WatchedPool pool = trial.earth();
        List<RigidBody> column = build(pool, 0, 0, new double[] {1, 1, 1, 1, 1});
        pool.run(HORIZON);
        double lean = column.stream().mapToDouble(disc -> Math.abs(disc.x())).max().orElse(0);
        trial.measure("lean", lean, "m", Trial.TOLERATED_OVERLAP, Double.POSITIVE_INFINITY);
        trial.variant("e 0.8");
        WatchedPool dropped = trial.earth();
        build(dropped, 0.1, 0.8, DENSITIES);
        dropped.run(HORIZON);
    }

    private static List<RigidBody> build(
            WatchedPool pool, double gap, double elasticity, double[] densities) {
        pool.add(Earth.floor(0.5, elasticity));
        List<RigidBody> column = new ArrayList<>();
        for (int i = 0; i < COUNT; i++) {
            column.add(
                    pool.add(
                            Solid.disc(0.5)
                                    .at(0, 0.5 + i + (i + 1) * gap)
                                    .material(new Material(densities[i], 0.5, elasticity))));
        }
        return column;
    }
}

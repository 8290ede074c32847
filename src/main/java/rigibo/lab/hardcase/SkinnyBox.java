package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Solid;

import java.util.Random;

/**
 * A thousand boxes of 4 × 0.1 fall at 100 m/s, turning by up to 50 rad/s, onto a plate with a post
 * of 0.2 × 2 on it. Truth: none is ever below the plate's surface.
 */
final class SkinnyBox implements Scenes {

    private static final long SEED = 44;
    private static final int COUNT = 1000;
    private static final int STEPS = 40;

    @Override
    public void run(Trial trial) {
        Random random = new Random(SEED);
        int lost = 0;
        for (int i = 0; i < COUNT; i++) {
            trial.variant("seed " + SEED + ", box " + i);
            lost += isLost(trial, random) ? 1 : 0;
        }
        trial.measure("below the floor, of 1,000", lost, "boxes", 0);
    }

    private static boolean isLost(Trial trial, Random random) {
        WatchedPool pool = trial.ground(0.5, 0.3);
        pool.add(Solid.fixed(0.2, 2).at(0, 1));
        RigidBody box =
                pool.add(
                        Solid.box(4, 0.1, 0.5, 0.3)
                                .at(6 * random.nextDouble() - 3, 5 + 5 * random.nextDouble())
                                .angle(2 * Math.PI * random.nextDouble())
                                .velocity(0, -100)
                                .spin(100 * random.nextDouble() - 50));
        for (int step = 0; step < STEPS; step++) {
            pool.step();
            if (box.y() < 0) {
                return true;
            }
        }
        return false;
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.Random;

/**
 * A thousand boxes of 4 × 0.1 fall at 100 m/s, turning by up to 50 rad/s, onto a plate with a post
 * of 0.2 × 2 on it. Truth: none is ever below the plate's surface.
 */
final class SkinnyBox implements HardCase {

    private static final long SEED = 44;
    private static final int COUNT = 1000;
    private static final int STEPS = 40;

    @Override
    public String row() {
        return "44";
    }

    @Override
    public String title() {
        return "a thin fast turning box never passes the floor";
    }

    @Override
    public String finding() {
        return "At DRAFT nobody looks for impacts in flight: what is fast is found in overlap a"
                + " step later, and pushed out.";
    }

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
        WatchedPool pool = trial.pool(Surroundings.earth());
        pool.add(Surroundings.floor(0.5, 0.3));
        pool.add(BodyDefinition.fixed(Polygon.box(0.2, 2)).at(0, 1));
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(4, 0.1))
                                .at(6 * random.nextDouble() - 3, 5 + 5 * random.nextDouble())
                                .angle(2 * Math.PI * random.nextDouble())
                                .velocity(0, -100)
                                .spin(100 * random.nextDouble() - 50)
                                .material(Surroundings.matter(0.5, 0.3)));
        for (int step = 0; step < STEPS; step++) {
            pool.step();
            if (box.y() < 0) {
                return true;
            }
        }
        return false;
    }
}

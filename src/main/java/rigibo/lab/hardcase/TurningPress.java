package rigibo.lab.hardcase;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.Random;

/**
 * Kinematic polygons that move and turn press bodies into a corner of fixed walls, in two hundred
 * random ways. Truth: bodies that cannot give way overlap, others are squeezed out. With μ = ½ a
 * wedge narrower than 2·atan μ = 53° holds its content, and a wider one expels it at no more than
 * the press's own speed over sin 26.6°. With 1.7 m/s of the press's outline and 3 m/s of push-out
 * that is below 7 m/s; the limit is 10. Impulses that answer two contradicting walls would explode.
 */
final class TurningPress implements Scenes {

    private static final long SEED = 64;
    private static final int COUNT = 200;
    private static final double HORIZON = 3;
    private static final double MOST_SPEED = 10;

    @Override
    public void run(Trial trial) {
        Random random = new Random(SEED);
        for (int i = 0; i < COUNT; i++) {
            trial.variant("seed " + SEED + ", press " + i);
            press(trial, random);
        }
    }

    private static void press(Trial trial, Random random) {
        WatchedPool pool = trial.ground(0.5, 0).allowingOverlap();
        pool.add(Solid.fixed(2, 20).at(-1, 10));
        Shape shape = Polygon.regular(3 + random.nextInt(6), 0.5);
        double angle = 2 * Math.PI * random.nextDouble();
        pool.add(
                BodyDefinition.kinematic(shape)
                        .at(2.5, 0.3 + 2 * random.nextDouble())
                        .angle(angle)
                        .velocity(-1, 0.4 * random.nextDouble() - 0.4)
                        .spin(2 * random.nextDouble() - 1));
        pool.add(pressed(random).at(0.6, 0.6));
        pool.add(pressed(random).at(0.7, 1.8));
        while (pool.time() < HORIZON) {
            int quarantined = pool.step().quarantined();
            trial.requireAlways("nothing is driven beyond all bounds", quarantined == 0);
            trial.measure("fastest", pool.fastest(), "m/s", MOST_SPEED);
        }
    }

    private static BodyDefinition pressed(Random random) {
        int corners = 3 + random.nextInt(5);
        return BodyDefinition.dynamic(Polygon.regular(corners, 0.5))
                .angle(2 * Math.PI * random.nextDouble());
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/**
 * Truth: a pyramid of boxes is at rest. With Sleep it sleeps within 2 s; without, nothing in it
 * moves faster than 1 mm/s after 10 s.
 */
final class Pyramid implements HardCase {

    private static final double HORIZON = 10;
    private static final double MOST_TIME_AWAKE = 2;
    private static final double MOST_SPEED = 1e-3;

    private final String row;
    private final int base;
    private final double side;

    Pyramid(String row, int base, double side) {
        this.row = row;
        this.base = base;
        this.side = side;
    }

    @Override
    public String row() {
        return row;
    }

    @Override
    public String title() {
        return "a pyramid with a base of " + base + " boxes of " + side + " m is at rest";
    }

    @Override
    public void run(Trial trial) {
        trial.variant("with sleep");
        WatchedPool sleeping = build(trial, Surroundings.earth().with(new Sleep()));
        sleeping.run(MOST_TIME_AWAKE);
        long awake = sleeping.pool().bodies().stream().filter(RigidBody::isAwake).count();
        trial.measure("awake after 2 s", awake, "bodies", 0);
        trial.variant("without sleep");
        WatchedPool pool = build(trial, Surroundings.earth());
        pool.run(HORIZON);
        double fastest = 0;
        for (RigidBody body : pool.pool().bodies()) {
            fastest = Math.max(fastest, Math.hypot(body.velocityX(), body.velocityY()));
        }
        trial.measure("fastest after 10 s", fastest, "m/s", MOST_SPEED);
    }

    private WatchedPool build(Trial trial, Effects effects) {
        WatchedPool pool = trial.pool(effects);
        pool.add(Surroundings.floor(0.6, 0));
        for (int storey = 0; storey < base; storey++) {
            for (int i = 0; i < base - storey; i++) {
                double x = side * (i - (base - storey - 1) / 2.0);
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(side, side))
                                .at(x, side * (storey + 0.5))
                                .material(Surroundings.matter(0.6, 0)));
            }
        }
        return pool;
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * Truth: a pyramid of boxes is at rest. With Sleep it sleeps within 2 s; without, nothing in it
 * moves faster than 1 mm/s after 10 s.
 */
record Pyramid(int base, double side) implements Scenes {

    private static final double HORIZON = 10;
    private static final double MOST_TIME_AWAKE = 2;
    private static final double MOST_SPEED = 1e-3;

    @Override
    public void run(Trial trial) {
        trial.variant("with sleep");
        WatchedPool sleeping = build(trial, Earth.effects().with(new Sleep()));
        sleeping.run(MOST_TIME_AWAKE);
        long awake = sleeping.pool().bodies().stream().filter(RigidBody::isAwake).count();
        trial.measure("awake after 2 s", awake, "bodies", 0);
        trial.variant("without sleep");
        WatchedPool pool = build(trial, Earth.effects());
        pool.run(HORIZON);
        trial.measure("fastest after 10 s", pool.fastest(), "m/s", MOST_SPEED);
    }

    private WatchedPool build(Trial trial, Effects effects) {
        WatchedPool pool = trial.pool(effects);
        pool.add(Earth.floor(0.6, 0));
        Solid.pyramid(Solid.box(side, side, 0.6, 0), base, side, 0).forEach(pool::add);
        return pool;
    }
}

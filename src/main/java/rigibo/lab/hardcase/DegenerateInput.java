package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Thrust;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.Locale;

/**
 * Truth: senseless input is refused by an exception that names the field, before anything changes.
 * Extreme input stays finite. A body driven beyond all numbers is put to rest and leaves no trace
 * in its neighbours.
 */
final class DegenerateInput implements Scenes {

    /** A force that the engine accepts, N, but that would give a body of 1 kg no finite speed. */
    private static final double BEYOND_ALL_BOUNDS = 1e300;

    @Override
    public void run(Trial trial) {
        refuse(trial);
        extreme(trial);
        trial.variant("one body driven beyond all numbers");
        poison(trial);
    }

    private static void refuse(Trial trial) {
        WatchedPool pool = trial.pool(Earth.effects().with(new Thrust()));
        pool.add(Earth.floor(0.5, 0));
        RigidBody box = pool.add(Solid.box(1, 1).at(0, 0.5));
        pool.step();
        new Refusals(pool.pool())
                .attempts()
                .forEach(
                        (name, attempt) -> {
                            trial.variant(name);
                            long before = pool.pool().stateHash();
                            String field = name.split(" ")[0].toLowerCase(Locale.ROOT);
                            String message = "";
                            try {
                                attempt.accept(box);
                            } catch (IllegalArgumentException refusal) {
                                message = refusal.getMessage().toLowerCase(Locale.ROOT);
                            }
                            trial.requireAlways("refused by name", message.contains(field));
                            boolean isSame = before == pool.pool().stateHash();
                            trial.requireAlways("a refusal changes nothing", isSame);
                        });
    }

    private static void extreme(Trial trial) {
        trial.variant("empty pool");
        trial.earth().step();
        trial.variant("a step of 10 s");
        WatchedPool longStep = trial.ground(0.5, 0);
        longStep.add(Solid.box(1, 1).at(0, 3));
        longStep.step(10);
        longStep.run(1);
        trial.variant("a step of 1 ns");
        WatchedPool shortStep = trial.ground(0.5, 0);
        shortStep.add(Solid.box(1, 1).at(0, 0.5));
        shortStep.step(1e-9);
        shortStep.run(1);
        trial.variant("a sliver of 1 to 10,000");
        WatchedPool sliver = trial.ground(0.5, 0);
        sliver.add(Solid.box(10, 1e-3).at(0, 1).angle(0.2));
        sliver.run(3);
        trial.variant("a grain and a planet");
        WatchedPool sizes = trial.space();
        sizes.add(Solid.disc(1e-6).at(-1, 0).velocity(1, 0));
        sizes.add(Solid.disc(1e6).at(1e6, 0));
        sizes.run(3);
        trial.variant("as fast as light");
        WatchedPool fast = trial.space();
        fast.add(Solid.fixed(1, 10).at(100, 0));
        fast.add(Solid.disc(1).velocity(299_792_458, 0));
        fast.run(0.5);
    }

    private static void poison(Trial trial) {
        WatchedPool pool = trial.pool(Earth.effects().with(new Thrust())).allowingOverlap();
        pool.add(Earth.floor(0.5, 0));
        RigidBody neighbour = pool.add(Solid.box(1, 1).at(0, 0.5));
        RigidBody poisoned = pool.add(Solid.box(1, 1).at(0, 1.5));
        pool.run(0.5);
        poisoned.applyForce(BEYOND_ALL_BOUNDS, 0, poisoned.x(), poisoned.y());
        int quarantined = pool.step().quarantined();
        trial.requireAlways("one body is put to rest and reported", quarantined == 1);
        pool.run(0.5);
        double moved = Math.hypot(neighbour.x(), neighbour.y() - 0.5);
        trial.measure("neighbour moved", moved, "m", 2 * Trial.TOLERATED_OVERLAP);
    }
}

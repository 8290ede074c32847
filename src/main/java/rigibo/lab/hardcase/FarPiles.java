package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Sleep;
import rigibo.lab.bench.scene.Scene;

/**
 * Piles at 10⁷ and 10⁸ m. Truth: the laws do not know where the origin is; neighbouring doubles are
 * 2e-9 and 1.5e-8 m apart there, so a pile at 10⁷ m costs what it costs at the origin, and at 10⁸ m
 * it still comes to rest.
 */
final class FarPiles implements Scenes {

    private static final double FAR = 1e7;
    private static final double FARTHEST = 1e8;
    private static final double COUNTED = 3;
    private static final double HORIZON = 10;
    private static final Limits MOST_WORK = Limits.same(1.5);
    private static final Limits AT_REST = Limits.same(1e-3);
    private static final Limits AWAKE = Limits.same(0);

    @Override
    public void run(Trial trial) {
        Piles.some(trial.sampling()).forEach((name, pile) -> compare(trial, name, pile));
    }

    private static void compare(Trial trial, String name, Scene pile) {
        trial.variant(name + " at the origin");
        Costs near = costs(trial, pile);
        trial.variant(name + " at " + FAR + " m");
        Costs far = costs(trial, Piles.shifted(pile, FAR));
        double work = far.work() / Math.max(near.work(), near.contacts());
        trial.measure("work at 1e7 m", work, "of that at 0", MOST_WORK);
        trial.variant(name + " at " + FARTHEST + " m");
        Scene farthest = Piles.shifted(pile, FARTHEST);
        StagedScene awake = new StagedScene(trial, farthest);
        awake.runUntil(HORIZON);
        trial.measure("fastest at 1e8 m", awake.pool().fastest(), "m/s", AT_REST);
        StagedScene asleep = new StagedScene(trial, farthest, farthest.effects().with(new Sleep()));
        asleep.runUntil(HORIZON);
        long count = asleep.dynamic().stream().filter(RigidBody::isAwake).count();
        trial.measure("awake at 1e8 m", count, "bodies", AWAKE);
    }

    private static Costs costs(Trial trial, Scene scene) {
        StagedScene stage = new StagedScene(trial, scene);
        Costs sum = new Costs(0, 0);
        while (stage.pool().time() < COUNTED) {
            stage.step();
            sum = sum.plus(Costs.of(stage.pool().pool().report()));
        }
        return sum;
    }
}

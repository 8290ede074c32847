package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Sleep;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.child.Work;

/**
 * Piles at 10⁷ and 10⁸ m. Truth: the laws do not depend on the origin. Neighbouring doubles are
 * 2e-9 and 1.5e-8 m apart there, so a pile at 10⁷ m takes the work that it takes at the origin, and
 * one at 10⁸ m still comes to rest.
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
        Work near = work(trial, pile);
        trial.variant(name + " at " + FAR + " m");
        Work far = work(trial, Piles.shifted(pile, FAR));
        double more = (double) far.solved() / Math.max(near.solved(), near.contacts());
        trial.measure("work at 1e7 m", more, "of that at 0", MOST_WORK);
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

    private static Work work(Trial trial, Scene scene) {
        StagedScene stage = new StagedScene(trial, scene);
        Work sum = Work.NONE;
        while (stage.pool().time() < COUNTED) {
            stage.step();
            sum = sum.plus(Work.of(stage.pool().pool().report()));
        }
        return sum;
    }
}

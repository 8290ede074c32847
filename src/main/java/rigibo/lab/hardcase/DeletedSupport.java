package rigibo.lab.hardcase;

import rigibo.backend.ContactEvent;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Sleep;
import rigibo.lab.truth.Bounces;
import rigibo.lab.truth.Earth;

import java.util.ArrayList;
import java.util.List;

/**
 * A stack of ten that is asleep loses box 0, 5 or 9, its floor, or a body named by a contact event.
 * Truth: every box above falls freely from the next step on, v = −g·dt after one step, without an
 * impulse left over in the contacts; every box below sleeps on.
 */
final class DeletedSupport implements Scenes {

    private static final int COUNT = 10;
    private static final double MOST_SECONDS_AWAKE = 5;
    private static final int STEPS_OF_FALL = 3;

    @Override
    public void run(Trial trial) {
        for (int removed : new int[] {0, 5, 9}) {
            trial.variant("box " + removed + " of a stack asleep");
            List<RigidBody> stack = new ArrayList<>();
            WatchedPool pool = asleep(trial, stack);
            pool.remove(stack.get(1 + removed));
            judge(trial, pool, stack, removed);
        }
        trial.variant("the floor");
        List<RigidBody> stack = new ArrayList<>();
        WatchedPool pool = asleep(trial, stack);
        pool.remove(stack.get(0));
        judge(trial, pool, stack, -1);
        trial.variant("the body a contact event names");
        removeOnEvent(trial);
    }

    private static WatchedPool asleep(Trial trial, List<RigidBody> stack) {
        WatchedPool pool = trial.pool(Earth.effects().with(new Sleep()));
        stack.add(pool.add(Earth.floor(0.5, 0)));
        stack.addAll(pool.stack(COUNT));
        while (pool.time() < MOST_SECONDS_AWAKE && stack.get(COUNT).isAwake()) {
            pool.step();
        }
        boolean isAsleep = stack.stream().noneMatch(RigidBody::isAwake);
        trial.require("the stack falls asleep", isAsleep);
        return pool;
    }

    /** Judges a stack in whose list the floor is first, so that box i is at i + 1. */
    private static void judge(Trial trial, WatchedPool pool, List<RigidBody> stack, int removed) {
        double[] start = stack.stream().mapToDouble(b -> b.isAlive() ? b.y() : 0).toArray();
        double step = Trial.GRAVITY * Trial.DT;
        for (int n = 1; n <= STEPS_OF_FALL; n++) {
            pool.step();
            double t = n * Trial.DT;
            for (int i = Math.max(removed + 1, 0); i < COUNT; i++) {
                RigidBody box = stack.get(i + 1);
                double off = Math.abs(box.velocityY() + Trial.GRAVITY * t);
                double kick = Math.abs(box.velocityX()) + Math.abs(box.angularVelocity());
                trial.measure("free fall", (off + kick) / step, "of g·dt", 1e-9, 1e-2);
                double fallen = start[i + 1] - Bounces.heightOfFall(t);
                double place = Math.abs(box.y() - fallen);
                trial.measure("place", place, "m", 1e-9, 1e-2 * step * Trial.DT);
                trial.require("awake in the same step", box.isAwake());
            }
        }
        for (int i = 0; i < removed; i++) {
            RigidBody box = stack.get(i + 1);
            trial.require("what is below sleeps on", !box.isAwake());
            double rise = box.y() - start[i + 1];
            trial.measure("rise of what is below", rise, "m", Trial.TOLERATED_OVERLAP);
        }
    }

    private static void removeOnEvent(Trial trial) {
        List<RigidBody> stack = new ArrayList<>();
        WatchedPool pool = asleep(trial, stack);
        stack.get(COUNT).wake();
        for (int i = 0; i < COUNT; i++) {
            pool.step();
            for (ContactEvent event : pool.pool().contactEvents()) {
                RigidBody victim = event.a() == stack.get(0) ? event.b() : event.a();
                if (victim.isAlive() && victim != stack.get(0)) {
                    pool.remove(victim);
                    break;
                }
            }
        }
        trial.require("bodies were removed", pool.pool().bodies().size() < COUNT + 1);
        pool.run(1);
    }
}

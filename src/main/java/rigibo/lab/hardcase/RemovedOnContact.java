package rigibo.lab.hardcase;

import rigibo.backend.ContactEvent;
import rigibo.backend.RigidBody;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * A body named by a contact event is removed as soon as the event is read, while all are awake.
 * Truth: a body that stood on it, or just struck it, keeps its velocity and falls freely from the
 * next step on, v = v₀ − g·t; every body below stays. The contact acts no more.
 */
final class RemovedOnContact implements Scenes {

    private static final int COUNT = 10;
    private static final int STEPS_OF_FALL = 6;
    private static final double RADIUS = 0.25;
    private static final double DROP = 1.5;

    /** Long enough for the drop, which takes 0.55 s. */
    private static final double MOST_SECONDS = 2;

    @Override
    public void run(Trial trial) {
        for (int removed : new int[] {0, 5, 9}) {
            trial.variant("box " + removed + " of a stack awake");
            fromAStack(trial, removed);
        }
        for (double e : new double[] {0, 0.5, 1}) {
            trial.variant("the floor that a disc struck, e " + e);
            underADisc(trial, e);
        }
    }

    private static void fromAStack(Trial trial, int removed) {
        WatchedPool pool = trial.earth();
        List<RigidBody> bodies = new ArrayList<>();
        bodies.add(pool.add(Earth.floor(0.5, 0)));
        bodies.addAll(pool.stack(COUNT));
        pool.run(1);
        RigidBody victim = bodies.get(removed + 1);
        boolean isNamed =
                pool.pool().contactEvents().stream().anyMatch(event -> names(event, victim));
        trial.require("an event names the body", isNamed);
        double[] heights = bodies.stream().mapToDouble(RigidBody::y).toArray();
        pool.remove(victim);
        judge(trial, pool, bodies.subList(removed + 2, COUNT + 1));
        for (int i = 1; i <= removed; i++) {
            double moved = Math.abs(bodies.get(i).y() - heights[i]);
            trial.measure("move of what is below", moved, "m", Trial.TOLERATED_OVERLAP);
        }
    }

    private static void underADisc(Trial trial, double e) {
        WatchedPool pool = trial.earth();
        RigidBody floor = pool.add(Earth.floor(0, e));
        RigidBody disc = pool.add(Solid.disc(RADIUS, 0, e).at(0, RADIUS + DROP).velocity(1, 0));
        boolean isStruck = false;
        while (!isStruck && pool.time() < MOST_SECONDS) {
            pool.step();
            isStruck =
                    pool.pool().contactEvents().stream()
                            .anyMatch(
                                    event ->
                                            event.phase() == ContactEvent.Phase.BEGIN
                                                    && names(event, floor));
        }
        trial.require("the impact is told", isStruck);
        pool.remove(floor);
        judge(trial, pool, List.of(disc));
    }

    private static boolean names(ContactEvent event, RigidBody body) {
        return event.a() == body || event.b() == body;
    }

    /** Judges with the limits for a sleeping stack that loses its support. */
    private static void judge(Trial trial, WatchedPool pool, List<RigidBody> falling) {
        double[] vx = falling.stream().mapToDouble(RigidBody::velocityX).toArray();
        double[] vy = falling.stream().mapToDouble(RigidBody::velocityY).toArray();
        double step = Trial.GRAVITY * Trial.DT;
        for (int n = 1; n <= STEPS_OF_FALL; n++) {
            pool.step();
            for (int i = 0; i < vx.length; i++) {
                RigidBody body = falling.get(i);
                double off = Math.abs(body.velocityY() - (vy[i] - n * step));
                double aside = Math.abs(body.velocityX() - vx[i]);
                double kick = off + aside + Math.abs(body.angularVelocity());
                trial.measure("free fall", kick / step, "of g·dt", 1e-9, 1e-2);
            }
        }
    }
}

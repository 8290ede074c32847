package rigibo.lab.hardcase;

import rigibo.backend.ContactEvent;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.child.Work;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A closed room with more bodies than fit. Truth: they cannot part, so they come to rest in
 * overlap, which is reported, and stay inside. Forces are of the size of weights, since no law asks
 * for more; and a step at rest takes no more work than one before.
 */
final class OverfullRoom implements Scenes {

    private static final double SIDE = 5;
    private static final double HORIZON = 10;
    private static final double TOLD_FROM = 0.05;
    private static final Limits AT_REST = Limits.same(1e-3);
    private static final Limits MOST_IMPULSE = Limits.same(10);
    private static final Limits MOST_WORK = Limits.same(1.05);
    private static final Limits NEVER = Limits.same(0);

    @Override
    public void run(Trial trial) {
        List<Double> fills = trial.sampling().of(List.of(1.07, 1.28), List.of(1.05, 1.1, 1.2, 1.3));
        for (double fill : fills) {
            for (boolean isRound : new boolean[] {false, true}) {
                trial.variant((isRound ? "discs, " : "boxes, ") + fill + " × the room");
                settle(trial, fill, isRound ? new Circle(0.3) : Polygon.box(0.7, 0.5));
            }
        }
    }

    private static void settle(Trial trial, double fill, Shape shape) {
        WatchedPool pool = trial.earth().allowingOverlap();
        BodyDefinition wall = Solid.fixed(SIDE + 4, 2);
        pool.add(wall.at(0, -1));
        pool.add(wall.at(0, SIDE + 1));
        pool.add(wall.at(-SIDE / 2 - 1, SIDE / 2).angle(Math.PI / 2));
        pool.add(wall.at(SIDE / 2 + 1, SIDE / 2).angle(Math.PI / 2));
        List<RigidBody> bodies = fill(trial, pool, fill, shape);
        double early = work(pool, 1);
        pool.run(HORIZON - 2);
        double late = work(pool, 1);
        trial.measure("fastest after 10 s", pool.fastest(), "m/s", AT_REST);
        double weight = bodies.stream().mapToDouble(RigidBody::mass).sum() * Trial.GRAVITY;
        double impulse = largestImpulse(pool) / (weight * Trial.DT);
        trial.measure("impulse at rest", impulse, "weights·dt", MOST_IMPULSE);
        trial.measure("work of a step, against the first second", late / early, "times", MOST_WORK);
        long outside = bodies.stream().filter(OverfullRoom::isOutside).count();
        trial.measure("outside of the room", outside, "bodies", NEVER);
        boolean isTold = pool.pool().report().crushed() > 0;
        boolean isDeep = pool.overlapNow() > TOLD_FROM;
        trial.measure("crushed and not told", isDeep && !isTold ? 1 : 0, "rooms", NEVER);
        trial.measure("overlap", pool.overlapNow(), "width", Limits.NONE);
    }

    /** Bodies whose areas add up to a multiple of the room's, at random places in it. */
    private static List<RigidBody> fill(Trial trial, WatchedPool pool, double fill, Shape shape) {
        SplittableRandom random = trial.sampling().random(Math.round(fill * 100));
        int count = (int) Math.ceil(fill * SIDE * SIDE / shape.area());
        double inside = SIDE - 2 * shape.boundingRadius();
        List<RigidBody> bodies = new ArrayList<>();
        int columns = (int) Math.ceil(Math.sqrt(count));
        int rows = (count + columns - 1) / columns;
        for (int i = 0; i < count; i++) {
            double x = inside * ((i % columns + random.nextDouble()) / columns - 0.5);
            double y = SIDE / 2 + inside * ((i / columns + random.nextDouble()) / rows - 0.5);
            bodies.add(
                    pool.add(
                            Solid.of(shape, 0.5, 0)
                                    .at(x, y)
                                    .angle(2 * Math.PI * random.nextDouble())));
        }
        return bodies;
    }

    private static boolean isOutside(RigidBody body) {
        return Math.max(Math.abs(body.x()), Math.abs(body.y() - SIDE / 2)) > SIDE / 2;
    }

    private static double work(WatchedPool pool, double seconds) {
        double work = 0;
        for (int i = 0; i < Math.round(seconds / Trial.DT); i++) {
            work += Work.of(pool.step()).solved();
        }
        return work;
    }

    private static double largestImpulse(WatchedPool pool) {
        return pool.pool().contactEvents().stream()
                .mapToDouble(ContactEvent::impulse)
                .max()
                .orElse(0);
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * Bodies that begin at one point, without weight. Truth: they part, at no more than three widths a
 * second by places, the push-out speed of a body of their size, however many there are. Then
 * nothing moves them.
 */
record BornAtOneSpot(Shape shape, List<Integer> few, List<Integer> all) implements Scenes {

    private static final double HORIZON = 10;
    private static final Limits MOST_WIDTHS_PER_SECOND = Limits.same(3);
    private static final Limits PARTED = Limits.same(0.005);
    private static final Limits AT_REST = Limits.same(1e-3);

    @Override
    public void run(Trial trial) {
        for (int count : trial.sampling().of(few, all)) {
            trial.variant(count + " bodies");
            part(trial, count);
        }
    }

    private void part(Trial trial, int count) {
        WatchedPool pool = trial.space().allowingOverlap();
        List<RigidBody> bodies = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            bodies.add(pool.add(BodyDefinition.dynamic(shape).at(1, 2).angle(0.3)));
        }
        double fastest = 0;
        while (pool.time() < HORIZON) {
            double[] x = bodies.stream().mapToDouble(RigidBody::x).toArray();
            double[] y = bodies.stream().mapToDouble(RigidBody::y).toArray();
            pool.step();
            for (int i = 0; i < count; i++) {
                double way = Math.hypot(bodies.get(i).x() - x[i], bodies.get(i).y() - y[i]);
                fastest = Math.max(fastest, way / Trial.DT / shape.smallestWidth());
            }
        }
        trial.measure("fastest, by places", fastest, "widths/s", MOST_WIDTHS_PER_SECOND);
        trial.measure("overlap after 10 s", pool.overlapNow(), "width", PARTED);
        trial.measure("fastest after 10 s", pool.fastest(), "m/s", AT_REST);
    }
}

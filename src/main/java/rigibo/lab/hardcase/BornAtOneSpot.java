package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * Bodies that begin at one spot, without weight. Truth: they must part, no faster than a body of
 * its size may be pushed, three widths a second by places, however many there are; then nothing
 * moves them.
 */
final class BornAtOneSpot implements HardCase {

    private static final double HORIZON = 10;
    private static final Limits MOST_WIDTHS_PER_SECOND = Limits.same(3);
    private static final Limits PARTED = Limits.same(0.005);
    private static final Limits AT_REST = Limits.same(1e-3);

    private final String row;
    private final Shape shape;
    private final List<Integer> few;
    private final List<Integer> all;

    private BornAtOneSpot(String row, Shape shape, List<Integer> few, List<Integer> all) {
        this.row = row;
        this.shape = shape;
        this.few = few;
        this.all = all;
    }

    static List<HardCase> cases() {
        Shape disc = new Circle(0.35);
        Shape box = Polygon.box(0.8, 0.6);
        List<Integer> several = List.of(2, 3, 5, 9);
        List<Integer> many = List.of(23, 50, 100, 200);
        return List.of(
                new BornAtOneSpot("M9/few-discs", disc, List.of(2, 9), several),
                new BornAtOneSpot("M9/few-boxes", box, List.of(2, 9), several),
                new BornAtOneSpot("M9/many-discs", disc, List.of(23), many),
                new BornAtOneSpot("M9/many-boxes", box, List.of(23), many));
    }

    @Override
    public String row() {
        return row;
    }

    @Override
    public String title() {
        return "bodies born at one spot part slowly, however many there are";
    }

    @Override
    public Preset limitedFrom() {
        return Preset.GAME;
    }

    @Override
    public String finding() {
        return "Each pair is pushed apart at up to 3 m/s by itself, and pushes add up"
                + " over the pairs of a body.";
    }

    @Override
    public void run(Trial trial) {
        for (int count : trial.sampling().of(few, all)) {
            trial.variant(count + " bodies");
            part(trial, count);
        }
    }

    private void part(Trial trial, int count) {
        WatchedPool pool = trial.pool(Surroundings.space()).allowingOverlap();
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

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

    private static final Shape DISC = new Circle(0.35);
    private static final Shape BOX = Polygon.box(0.8, 0.6);

    private static final String LINE =
            "What begins at the very same place parts along one line: 200 bodies need more than"
                    + " 10 s for that at three widths a second.";

    private final String row;
    private final Shape shape;
    private final List<Integer> few;
    private final List<Integer> all;
    private final String finding;

    private BornAtOneSpot(
            String row, Shape shape, List<Integer> few, List<Integer> all, String finding) {
        this.finding = finding;
        this.row = row;
        this.shape = shape;
        this.few = few;
        this.all = all;
    }

    /** Up to nine. */
    static List<HardCase> several() {
        List<Integer> all = List.of(2, 3, 5, 9);
        return List.of(
                new BornAtOneSpot("M9/few-discs", DISC, List.of(2, 9), all, ""),
                new BornAtOneSpot("M9/few-boxes", BOX, List.of(2, 9), all, ""));
    }

    /** Up to two hundred. */
    static List<HardCase> many() {
        List<Integer> all = List.of(23, 50, 100, 200);
        return List.of(
                new BornAtOneSpot("M9/many-discs", DISC, List.of(23), all, LINE),
                new BornAtOneSpot("M9/many-boxes", BOX, List.of(23), all, LINE));
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
        return finding;
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

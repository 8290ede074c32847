package rigibo.fuzz.judge;

import static rigibo.fuzz.judge.LawBroken.unless;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.StepReport;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyType;

import java.util.ArrayList;
import java.util.List;

/** The laws of every step. */
final class StepLaws {

    private static final String STILL = "what is static stays where it is";
    private static final String REPORT = "a step's report is consistent";

    /** Of one pair in a pile: 32 together with others, and in 8 sweeps alone. */
    private static final int MOST_IMPACTS_PER_SUBSTEP = 40;

    /** How many times the usual substeps a few bodies are given that spin. */
    private static final int MOST_MORE_SUBSTEPS = 16;

    /**
     * A normal, a friction and a rolling row for each of two points; a joint has no more: three
     * equations, two limits and a motor.
     */
    private static final int MOST_ROWS_PER_PAIR = 6;

    /** The former place of a static body. */
    private record Place(RigidBody body, double x, double y, double angle) {

        boolean isTheSame() {
            return body.x() == x && body.y() == y && body.angle() == angle;
        }
    }

    private final ContactStream contacts = new ContactStream();
    private final List<Place> places = new ArrayList<>();
    private double time;

    void restored(Pool pool) {
        contacts.restored(pool);
    }

    void before(Pool pool) {
        time = pool.time();
        places.clear();
        for (RigidBody body : pool.bodies()) {
            if (body.type() == BodyType.STATIC) {
                places.add(new Place(body, body.x(), body.y(), body.angle()));
            }
        }
    }

    void after(Pool pool, double dt) {
        unless(pool.time() == time + dt, "time goes on by the step", "it is %s", pool.time());
        for (Place place : places) {
            unless(place.isTheSame(), STILL, "%s was at %s", place.body(), place);
        }
        States.requireSound(pool);
        requireConsistent(pool, pool.report());
        contacts.after(pool);
    }

    private static void requireConsistent(Pool pool, StepReport report) {
        int bodies = pool.bodies().size();
        requireWithin("bodies", report.bodies(), bodies, bodies);
        requireWithin("awake", report.awake(), 0, bodies);
        long shapes = pool.bodies().stream().mapToLong(body -> body.shape().parts()).sum();
        requireWithin("pairs", report.pairs(), 0, shapes * (shapes - 1) / 2);
        requireWithin("contacts", report.contacts(), 0, report.pairs());
        requireWithin("crushed", report.crushed(), 0, report.pairs());
        requireWithin("quarantined", report.quarantined(), 0, bodies);
        long rows = (long) MOST_ROWS_PER_PAIR * (report.pairs() + pool.joints().size());
        requireWithin("rows", report.rows(), 0, rows);
        requireWithin("impacts", report.impacts(), 0, mostImpacts(pool, report));
        requireWithin("evaluations", report.evaluations(), 0, mostEvaluations(pool, report));
        double depth = report.deepestOverlap();
        unless(depth >= 0 && depth < Double.POSITIVE_INFINITY, REPORT, "overlap is %s", depth);
        for (int i = 0; i < report.quarantined(); i++) {
            unless(report.quarantined(i).isAlive(), REPORT, "who is quarantined is gone");
        }
    }

    /**
     * Each pair as often as the accuracy allows in flight, and so often in each substep of a pile.
     */
    private static long mostImpacts(Pool pool, StepReport report) {
        Accuracy accuracy = pool.accuracy();
        // Half a kick ends the step, in which impacts are struck once more.
        int substeps = accuracy.substeps() * MOST_MORE_SUBSTEPS + 1;
        int inPiles = substeps * MOST_IMPACTS_PER_SUBSTEP;
        return (long) report.pairs() * (accuracy.maxImpactsPerPair() + inPiles);
    }

    private static long mostEvaluations(Pool pool, StepReport report) {
        return 1000L * (report.pairs() + mostImpacts(pool, report));
    }

    private static void requireWithin(String what, long count, long least, long most) {
        unless(
                count >= least && count <= most,
                REPORT,
                "%s must be %d to %d, was %d",
                what,
                least,
                most,
                count);
    }
}

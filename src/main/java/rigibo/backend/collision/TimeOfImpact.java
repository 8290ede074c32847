package rigibo.backend.collision;

import rigibo.backend.setup.ImpactSearch;

/**
 * When two moving shapes first touch: the origin report's binary search, made safe.
 *
 * <p>Looking only at the ends of an interval misses a hit; a spinning rod can touch and be clear
 * again. So an interval is bracketed first. Along the axis between the closest points the gap s is
 * the least of smooth functions, one per pair of corners, whose second derivative is at most κ
 * (relative acceleration, plus ω²r where a polygon turns). Over an interval Δ it therefore stays
 * above its chord by no less than −κτ(Δ − τ)/2, the error bound of linear interpolation. Where that
 * clears the stopping gap, nothing can touch; else its first root is a time that is safe to advance
 * to. Once κΔ²/8 is a fraction of the tolerance the root is searched on the axis itself.
 */
public final class TimeOfImpact {

    /** Returned when the shapes do not touch. */
    public static final double NEVER = Double.POSITIVE_INFINITY;

    /** The gap that is left at an impact, as a share of the tolerance: small, and never 0. */
    private static final double STOPPING_SHARE = 1.0 / 5;

    /** An impact is taken at up to this many times the stopping gap. */
    private static final double STOPPING_SLACK = 1.25;

    /** Share of the tolerance that the gap may dip below its chord in the last bracket. */
    private static final double DIP_SHARE = 1.0 / 16;

    /** Rounds before the safe time reached so far is taken; met only by grazing contacts. */
    private static final int MOST_ROUNDS = 96;

    private final Collider collider = new Collider();
    private final Manifold manifold = new Manifold();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private final AxisGap axis = new AxisGap();
    private final RootSearch roots = new RootSearch();

    /** Evaluations of a gap in the last call. */
    public int evaluations;

    /**
     * Finds the first time at which the gap of two shapes has closed to a small positive rest and
     * still closes.
     *
     * @param a motion of the first shape
     * @param b motion of the second
     * @param start from when on, s
     * @param end until when, s
     * @param tolerance for shapes of one metre, m; scales with the narrower shape up to there
     * @param search how the root in the last bracket is found
     * @return s, or {@link #NEVER}
     */
    public double find(
            Motion a, Motion b, double start, double end, double tolerance, ImpactSearch search) {
        axis.evaluations = 0;
        double width = Math.min(a.shape.smallestWidth(), b.shape.smallestWidth());
        double fine = tolerance * Math.min(1, width);
        double kappa = a.curvature(end) + b.curvature(end);
        double time = NEVER;
        if (mayMeet(a, b, start, end, kappa)) {
            time = advance(a, b, start, end, fine, search, kappa);
        }
        evaluations = axis.evaluations;
        return time;
    }

    /** Whether the bounding circles can meet at all. */
    private boolean mayMeet(Motion a, Motion b, double start, double end, double kappa) {
        a.poseAt(start, poseA);
        b.poseAt(start, poseB);
        double dx = poseB.x - poseA.x;
        double dy = poseB.y - poseA.y;
        double vx = b.velocityXAt(start) - a.velocityXAt(start);
        double vy = b.velocityYAt(start) - a.velocityYAt(start);
        double left = end - start;
        double way = left * (Math.sqrt(vx * vx + vy * vy) + left * kappa / 2);
        double reach = a.shape.boundingRadius() + b.shape.boundingRadius() + way;
        return dx * dx + dy * dy <= reach * reach;
    }

    private double advance(
            Motion a,
            Motion b,
            double start,
            double end,
            double tolerance,
            ImpactSearch search,
            double kappa) {
        double stop = STOPPING_SHARE * tolerance;
        double time = start;
        for (int round = 0; round < MOST_ROUNDS; round++) {
            double gap = measure(a, b, time);
            double speed = axis.speedAt(time, stop);
            if (gap <= STOPPING_SLACK * stop) {
                if (speed < 0 && (round > 0 || gap <= 0)) {
                    return time;
                }
                // Closer than the stopping gap and not closing: it may close half of what is left.
                stop = gap > 0 ? gap / 2 : gap - tolerance;
            }
            double interval = interval(gap, speed, kappa, end - time);
            if (interval <= 0) {
                return NEVER;
            }
            double next = safeTime(time, interval, gap, stop, tolerance, kappa, search);
            if (next >= end) {
                return NEVER;
            }
            time = next;
        }
        return time;
    }

    /** The gap at a time, and the axis of the closest points from then on. */
    private double measure(Motion a, Motion b, double time) {
        axis.evaluations++;
        a.poseAt(time, poseA);
        b.poseAt(time, poseB);
        collider.collide(a.shape, poseA, b.shape, poseB, Double.POSITIVE_INFINITY, manifold);
        axis.fix(a, b, manifold.normalX, manifold.normalY);
        return manifold.count == 1
                ? manifold.separation[0]
                : Math.min(manifold.separation[0], manifold.separation[1]);
    }

    /**
     * How far to look: as far as the curve cannot eat half the gap, and no farther than about twice
     * the time to touch, where the bound converges quadratically.
     */
    private static double interval(double gap, double speed, double kappa, double left) {
        double byCurve = kappa > 0 ? Math.sqrt(4 * gap / kappa) : left;
        double bySpeed = kappa > 0 && speed < 0 ? Math.max(2 * gap / -speed, byCurve / 64) : left;
        return Math.min(left, Math.min(byCurve, bySpeed));
    }

    /** The end of the interval where it is clear, else a time in it up to which it is. */
    private double safeTime(
            double time,
            double interval,
            double gap,
            double stop,
            double tolerance,
            double kappa,
            ImpactSearch search) {
        double endGap = axis.at(time + interval);
        double dip = kappa * interval * interval / 8;
        if (Math.min(gap, endGap) - dip > stop) {
            return time + interval;
        }
        if (dip <= DIP_SHARE * Math.min(tolerance, 8 * stop)) {
            return endGap > stop
                    ? time + interval
                    : roots.find(axis, time, gap, time + interval, endGap, stop, search);
        }
        double slope = (endGap - gap) / interval - kappa * interval / 2;
        return time + Math.min(interval, firstRoot(kappa / 2, slope, gap - stop));
    }

    /**
     * The smaller root of pτ² + qτ + r = 0 with p, r &gt; 0, by the form that does not cancel;
     * infinite where there is none ahead.
     */
    private static double firstRoot(double p, double q, double r) {
        double discriminant = q * q - 4 * p * r;
        return q < 0 && discriminant >= 0
                ? 2 * r / (-q + Math.sqrt(discriminant))
                : Double.POSITIVE_INFINITY;
    }
}

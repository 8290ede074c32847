package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.NormalSource;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.setup.ImpactSearch;

/**
 * The time of impact of two moving shapes: a root search that cannot skip an impact.
 *
 * <p>Testing only the ends of an interval would miss impacts, since a spinning rod can touch and be
 * clear again. So the search keeps the axis between the closest points for a while, either fixed in
 * the world or turning with the face whose normal it is. Along it the gap is the least of smooth
 * functions, one per pair of corners, that curve upwards by at most κ. Over an interval Δ it lies
 * below its chord by at most κτ(Δ − τ)/2, the error bound of linear interpolation. If this bound
 * stays above the stopping gap, nothing can touch; otherwise its first root is a time to which it
 * is safe to advance. If the gap has closed at the interval's end, its own root is searched, which
 * is the first one if the bound has no root before it. Then the closest points are computed again.
 * This is conservative advancement (B. V. Mirtich, Impulse-based Dynamic Simulation of Rigid Body
 * Systems, 1996) with a bound that converges quadratically.
 */
public final class TimeOfImpact {

    /** Returned when the shapes do not touch. */
    public static final double NEVER = Double.POSITIVE_INFINITY;

    /** Range of the gap left at an impact, as shares of the tolerance; never 0. */
    private static final double LEAST_SHARE = 0.15;

    private static final double LARGEST_SHARE = 0.25;

    /** Gap, in units in the last place of a coordinate, below which it counts as round-off. */
    private static final double ROUNDING_UNITS = 4;

    /**
     * Gap left at the impact of a disc, as a multiple of that round-off; enough not to be lost
     * again.
     */
    private static final double POLISHED_ROUNDINGS = 8;

    /**
     * Most Newton steps. Each doubles the digits; from a gap of 0.1 mm three reach the last one.
     */
    private static final int MOST_POLISHES = 4;

    /**
     * Most rounds until the safe time reached so far is returned; only long, close passes need as
     * many.
     */
    private static final int MOST_ROUNDS = 400;

    /**
     * Longest correction by Newton steps, as a share of the searched time; the closing speed must
     * not change during it.
     */
    private static final double MOST_POLISH = 0.01;

    /**
     * Largest angle in rad through which both may turn while one turning axis is kept. The bound on
     * the gap in front of a turning face grows with the square of that angle. Over many turns it is
     * useless, and each round would advance by a thousandth of a turn.
     */
    private static final double LONGEST_TURN = 0.5;

    private final Distance distance = new Distance();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private final FixedAxisGap fixedAxis = new FixedAxisGap();
    private final TurningFaceGap turningFace = new TurningFaceGap();
    private final Approach approach = new Approach();
    private final SafeAdvance advance = new SafeAdvance();

    /** Number of gap evaluations in the last call. */
    public int evaluations;

    /** Whether the last call gave up and returned a safe time before the impact. */
    public boolean isConservative;

    private Motion a;
    private Motion b;
    private GapAlong axis;
    private double end;

    /** Tolerance for these two shapes, and gap below which it counts as round-off, m. */
    private double tolerance;

    private double rounding;

    /**
     * Finds the first time at which the gap of two approaching shapes has closed to a small
     * positive value. That value lies between ⅛ and ¼ of the tolerance; where a disc meets a shape
     * that does not turn it is a few units of round-off. A pair that starts with a smaller gap and
     * parts is not reported; if it comes back, it is reported at half its first gap. A pair that
     * starts in overlap is reported at once if it approaches, otherwise when the overlap has grown
     * by up to a tolerance.
     *
     * @param first motion of A
     * @param second motion of B
     * @param from start of the search, s
     * @param to end of the search, s
     * @param metres tolerance for shapes of one metre; scales with the narrower shape
     * @param how method to find a root in a bracket
     * @return s, or {@link #NEVER}
     */
    public double find(
            Motion first, Motion second, double from, double to, double metres, ImpactSearch how) {
        a = first;
        b = second;
        end = to;
        advance.begin(how);
        evaluations = 0;
        isConservative = false;
        approach.between(a, b);
        a.placeAt(from, poseA);
        b.placeAt(from, poseB);
        setTolerance(metres);
        if (!approach.mayMeet(poseA, poseB, from, to, tolerance)) {
            return NEVER;
        }
        double time = run(from);
        evaluations += advance.evaluations;
        return time;
    }

    private void setTolerance(double metres) {
        double width = Math.min(a.outline.smallestWidth(), b.outline.smallestWidth());
        double far = Math.max(farthest(a), farthest(b));
        rounding = ROUNDING_UNITS * (Math.nextUp(far) - far);
        tolerance = Math.max(metres * width, rounding / LEAST_SHARE);
        advance.stopBetween(LEAST_SHARE * tolerance, LARGEST_SHARE * tolerance);
        distance.near(LARGEST_SHARE * tolerance);
    }

    private static double farthest(Motion of) {
        return Math.max(Math.abs(of.x), Math.abs(of.y)) + of.outline.boundingRadius();
    }

    private double run(double from) {
        double time = from;
        for (int round = 0; round < MOST_ROUNDS; round++) {
            double gap = measure(time, round);
            if (round > 0 && !approach.mayMeet(poseA, poseB, time, end, tolerance)) {
                return NEVER;
            }
            if (gap > LARGEST_SHARE * tolerance) {
                advance.stopBetween(LEAST_SHARE * tolerance, LARGEST_SHARE * tolerance);
            } else if (gap <= advance.largest) {
                if ((round > 0 || gap <= rounding)
                        && approach.isClosing(distance, poseA, poseB, time, tolerance)) {
                    return polished(from, time, gap);
                }
                stopBelow(gap);
            }
            double next = advance.from(axis, time, gap, interval(time, gap, round));
            if (next >= end) {
                return NEVER;
            }
            if (!(next > time)) {
                break;
            }
            time = next;
        }
        isConservative = true;
        return time;
    }

    /**
     * Moves the root to the middle of the stopping gap by Newton steps. A mirrored or exchanged
     * pair then meets at the same time, to nearly all digits; without them, the root lies anywhere
     * in that range, and after one step it still depends on where in the range the search stopped.
     */
    private double polished(double from, double found, double foundGap) {
        double middle = (advance.least + advance.largest) / 2;
        boolean isOfDisc = isDisc(a) && !b.isTurning() || isDisc(b) && !a.isTurning();
        if (isOfDisc) {
            double least = Math.min(POLISHED_ROUNDINGS * rounding, middle);
            return touching(from, found, foundGap, least);
        }
        double near = newton(from, found, found, foundGap - middle);
        double left = near == found ? 0 : gapAt(near) - middle;
        boolean isNearer = Math.abs(left) < Math.abs(foundGap - middle);
        return isNearer ? newton(from, found, near, left) : found;
    }

    /**
     * Refines the impact of a disc on a shape that does not turn. They touch in a single point, so
     * more Newton steps can lead to the smallest gap above round-off, and the rebound begins where
     * it should.
     */
    private double touching(double from, double found, double foundGap, double aim) {
        double safe = found;
        double time = found;
        double above = foundGap - aim;
        for (int i = 0; i < MOST_POLISHES; i++) {
            double better = newton(from, found, time, above);
            if (better == time) {
                break;
            }
            time = better;
            above = gapAt(time) - aim;
            safe = above >= -rounding ? time : safe;
        }
        return safe;
    }

    /**
     * One Newton step from the time measured last, where the gap is {@code above} m more than
     * intended. Returns the same time if that is round-off, or if the step leaves the range in
     * which the closing speed holds.
     */
    private double newton(double from, double found, double time, double above) {
        double speed = approach.partingSpeed(distance, poseA, poseB, time, tolerance);
        double better = time - above / speed;
        boolean isOff = Math.abs(above) > rounding;
        boolean isNear = speed < 0 && Math.abs(better - found) <= MOST_POLISH * (end - from);
        return isOff && isNear && better >= from && better <= end ? better : time;
    }

    private static boolean isDisc(Motion of) {
        return of.outline.isDisc() && (of.outline.isCentredDisc() || !of.isTurning());
    }

    private double gapAt(double time) {
        evaluations++;
        a.poseAt(time, poseA);
        b.poseAt(time, poseB);
        return distance.measure(a.outline, poseA, b.outline, poseB);
    }

    /**
     * Lowers the stopping gap for a pair that is close but parts: to half its gap, or to deeper
     * overlap.
     */
    private void stopBelow(double gap) {
        if (gap > rounding) {
            advance.stopBetween(gap / 2, gap / 2 * (LARGEST_SHARE / LEAST_SHARE));
        } else {
            advance.stopBetween(gap - tolerance, gap - tolerance / 2);
        }
    }

    /**
     * Measures the gap at a time, and fixes the axis of the closest points. The first round uses a
     * fixed axis, since most pairs that stay clear need no other.
     */
    private double measure(double time, int round) {
        double gap = gapAt(time);
        double x = distance.axisX;
        double y = distance.axisY;
        NormalSource source = distance.manifold.source;
        if (round > 0 && source == NormalSource.FACE_A && a.isTurning()) {
            turningFace.fix(a, poseA, b, poseB, x, y, gap);
            axis = turningFace;
        } else if (round > 0 && source == NormalSource.FACE_B && b.isTurning()) {
            turningFace.fix(b, poseB, a, poseA, -x, -y, gap);
            axis = turningFace;
        } else {
            fixedAxis.fix(a, poseA, b, poseB, x, y);
            axis = fixedAxis;
        }
        return gap;
    }

    /**
     * Length of the next interval, s: at first up to the end, then about twice the time to close,
     * and never longer than a turning axis is reliable.
     */
    private double interval(double time, double gap, int round) {
        double left =
                axis == turningFace ? Math.min(end - time, LONGEST_TURN / spin(time)) : end - time;
        double speed =
                round == 0 ? 0 : approach.partingSpeed(distance, poseA, poseB, time, tolerance);
        return speed < 0 ? Math.min(left, 2 * (gap - advance.least) / -speed) : left;
    }

    /** Sum of both angular speeds, rad/s. */
    private double spin(double time) {
        return Math.abs(a.spinAt(time)) + Math.abs(b.spinAt(time));
    }
}

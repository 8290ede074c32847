package rigibo.backend.collision;

import rigibo.backend.setup.ImpactSearch;

/**
 * When two moving shapes first touch: binary search, made safe.
 *
 * <p>Looking only at the ends of an interval misses a hit; a spinning rod can touch and be clear
 * again. So the axis between the closest points is kept for a while, fixed in the world or turning
 * with the face it is the normal of. Along it the gap is the least of smooth functions, one per
 * pair of corners, that curve upwards by at most κ. Over an interval Δ it stays above its chord but
 * for κτ(Δ − τ)/2, the error bound of linear interpolation. Where that clears the stopping gap
 * nothing can touch, and its first root is a time that is safe to advance to. Where the gap itself
 * has closed at the interval's end, its root is searched, and is the first one if the bound up to
 * there has none. Then the closest points are sought anew. This is conservative advancement (B. V.
 * Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996) with a bound that
 * converges quadratically.
 */
public final class TimeOfImpact {

    /** Returned when the shapes do not touch. */
    public static final double NEVER = Double.POSITIVE_INFINITY;

    /** The least and the largest gap left at an impact, as shares of the tolerance: never 0. */
    private static final double LEAST_SHARE = 0.15;

    private static final double LARGEST_SHARE = 0.25;

    /** Units in the last place of a coordinate that a gap must have to be told from none. */
    private static final double ROUNDING_UNITS = 4;

    /** The gap left where a disc touches, in such roundings: not so few as to be lost again. */
    private static final double POLISHED_ROUNDINGS = 8;

    /** Newton's steps: each doubles the digits, and from a gap of 0.1 mm three come to the last. */
    private static final int MOST_POLISHES = 4;

    /** Rounds before the safe time reached so far is taken; met only by long, close passes. */
    private static final int MOST_ROUNDS = 400;

    /**
     * Longest way of the last correction, of the time searched: the speed must not change in it.
     */
    private static final double MOST_POLISH = 0.01;

    /**
     * Angle in rad that both may turn while a turning axis is looked along. What the gap in front
     * of a turning face can bend by grows with the square of that angle: over many turns the bound
     * says nothing, and each round would come on by a thousandth of a turn.
     */
    private static final double LONGEST_TURN = 0.5;

    private final Distance distance = new Distance();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private final FixedAxisGap fixedAxis = new FixedAxisGap();
    private final TurningFaceGap turningFace = new TurningFaceGap();
    private final Approach approach = new Approach();
    private final SafeAdvance advance = new SafeAdvance();

    /** Evaluations of a gap in the last call. */
    public int evaluations;

    /** Whether the last call gave up and returned a time that is safe, but before the impact. */
    public boolean isConservative;

    private Motion a;
    private Motion b;
    private GapAlong axis;
    private double end;

    /** The tolerance for these two shapes, and what a gap must have to be told from none, m. */
    private double tolerance;

    private double rounding;

    /**
     * Finds the first time at which the gap of two shapes has closed to a small positive rest and
     * still closes. The rest lies between ⅛ and ¼ of the tolerance; where a disc meets what does
     * not turn it is round-off. A pair that starts closer than that and parts is not reported; one
     * that comes back is, at half the gap it started with. A pair that starts in overlap is
     * reported at once if it closes, and else when it has closed by the tolerance again.
     *
     * @param first motion of A
     * @param second motion of B
     * @param from when on, s
     * @param to until when, s
     * @param metres tolerance for shapes of one metre; scales with the narrower shape
     * @param how how the root in a bracket is found
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
        rounding = ROUNDING_UNITS * Math.ulp(Math.max(farthest(a), farthest(b)));
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
     * The root lies anywhere within the stopping gap. A step of Newton's puts it on its middle, so
     * that a mirrored or exchanged pair meets at the same time, to nearly all digits.
     */
    private double polished(double from, double found, double foundGap) {
        double middle = (advance.least + advance.largest) / 2;
        boolean isOfDisc = isDisc(a) && !b.isTurning() || isDisc(b) && !a.isTurning();
        return isOfDisc
                ? touching(from, found, foundGap, Math.min(POLISHED_ROUNDINGS * rounding, middle))
                : newton(from, found, found, foundGap - middle);
    }

    /**
     * A disc meets what does not turn in one point and nowhere else: there more steps lead to the
     * least gap that can be told from none, and a rebound begins where it should.
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
     * A step of Newton's from the time that was measured last, at a gap in m above the one aimed
     * at; the same time where that is none to round-off, or the step leads farther than speeds can
     * be relied on.
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

    /** Lets a pair that is close, but parts, come back to half its gap, or to deeper overlap. */
    private void stopBelow(double gap) {
        if (gap > rounding) {
            advance.stopBetween(gap / 2, gap / 2 * (LARGEST_SHARE / LEAST_SHARE));
        } else {
            advance.stopBetween(gap - tolerance, gap - tolerance / 2);
        }
    }

    /**
     * The gap at a time, and the axis of the closest points from then on. The first look goes along
     * an axis that stays, for most pairs that stay clear need no other.
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
     * How far to look, s: to the end at first, then about twice the time that closing takes, and no
     * farther than an axis that turns can be relied on.
     */
    private double interval(double time, double gap, int round) {
        double left =
                axis == turningFace ? Math.min(end - time, LONGEST_TURN / spin(time)) : end - time;
        double speed =
                round == 0 ? 0 : approach.partingSpeed(distance, poseA, poseB, time, tolerance);
        return speed < 0 ? Math.min(left, 2 * (gap - advance.least) / -speed) : left;
    }

    /** How fast both turn, rad/s. */
    private double spin(double time) {
        return Math.abs(a.spinAt(time)) + Math.abs(b.spinAt(time));
    }
}

package rigibo.backend.collision;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * Lends a pair the contact point of another one between the same two bodies while piles are solved.
 * A box of two halves stands on another box with two points, one of each half. As two contacts
 * these would have two friction rows along one line, which elimination cannot tell apart, and
 * passes would solve one end of the box after the other. As one contact of two points, the box is
 * solved as if it were of one piece. Afterwards each pair has its own points and forces again, so
 * that contacts are reported by part.
 */
final class OuterPoints {

    /**
     * Bit that marks the feature of a lent point, which could equal that of the borrower's own one.
     */
    private static final int LENT = 1 << 30;

    private final Bodies bodies;
    private final Pairs pairs;

    /** Pairs that have borrowed a point; and by pair, the lender or {@link Pairs#NONE}. */
    private final Found borrowers = new Found();

    private int[] lenderOf = new int[0];

    /** By borrower: its impulse (N·s) and number of impacts before it borrowed. */
    private double[] impulseBefore = new double[0];

    private int[] impactsBefore = new int[0];

    OuterPoints(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
    }

    /** Makes room for the present pairs, none of which has borrowed a point. */
    void begin() {
        int room = pairs.room();
        if (lenderOf.length < room) {
            lenderOf = new int[room];
            impulseBefore = new double[room];
            impactsBefore = new int[room];
            Arrays.fill(lenderOf, Pairs.NONE);
        }
    }

    /**
     * Whether a pair may lend or borrow: it has a single point, and its corners are not rounded.
     */
    boolean mayTakePart(int pair) {
        return pairs.points[pair] == 1
                && lenderOf[pair] == Pairs.NONE
                && isSharp(pairs.shapeA(pair))
                && isSharp(pairs.shapeB(pair));
    }

    private boolean isSharp(int shape) {
        return !bodies.outline[shape].isDisc() && bodies.outline[shape].radius() == 0;
    }

    /** Lends a pair the only point of another one that was measured at the same poses. */
    void lend(int borrower, int lender) {
        borrowers.add(borrower);
        lenderOf[borrower] = lender;
        impulseBefore[borrower] = pairs.impulse[borrower];
        impactsBefore[borrower] = pairs.impacts[borrower];
        if (pairs.frictionForce != null) {
            pairs.frictionForce[borrower] =
                    pairs.heldFriction(borrower) + pairs.heldFriction(lender);
        }
        takeAll(borrower, lender, 0);
    }

    /** The pair that lent a point to another one, or {@link Pairs#NONE}. */
    int lenderOf(int pair) {
        return pair < lenderOf.length ? lenderOf[pair] : Pairs.NONE;
    }

    /** Gives lent points back; returns how many points of its own the borrower is left with. */
    int giveBack(int borrower) {
        int lender = lenderOf[borrower];
        int own = 0;
        while (own < pairs.points[borrower]) {
            int point = 2 * borrower + own;
            boolean isLent = (pairs.feature[point] & LENT) != 0;
            if (isLent) {
                pairs.feature[point] &= ~LENT;
                pairs.takePoint(lender, borrower, own);
            } else {
                own++;
            }
        }
        return own;
    }

    /**
     * Lends again after both pairs were measured within the step: of the deep points, the borrower
     * gets the two that lie farthest apart. Before, it had {@code ownBefore} points of its own.
     */
    void lendAgain(int borrower, int ownBefore) {
        int lender = lenderOf[borrower];
        if (pairs.points[lender] == 0) {
            return;
        }
        if (pairs.points[borrower] == 0) {
            pairs.normalX[borrower] = pairs.normalX[lender];
            pairs.normalY[borrower] = pairs.normalY[lender];
            pairs.faceOf[borrower] = pairs.faceOf[lender];
        }
        while (pairs.points[borrower] + pairs.points[lender] > 2) {
            removeOne(borrower, lender);
        }
        takeAll(borrower, lender, ownBefore);
    }

    private void takeAll(int borrower, int lender, int ownBefore) {
        while (pairs.points[lender] > 0) {
            int point = 2 * lender;
            pairs.feature[point] |= LENT;
            if (pairs.former[point] != Pairs.NONE) {
                pairs.former[point] += ownBefore;
            }
            pairs.takePoint(borrower, lender, 0);
        }
    }

    /**
     * Removes one of three or four points: the one farthest from the first and the last on the
     * line. If that one lies deeper than the line through these two, the less deep of the two is
     * removed instead: a foot may stand on the lower of its corners and have another corner farther
     * out above the ground.
     */
    private void removeOne(int borrower, int lender) {
        int first = outermost(borrower, lender, -1);
        int last = outermost(borrower, lender, 1);
        double low = along(borrower, first);
        double high = along(borrower, last);
        int inner = first;
        double most = -1;
        for (int i = 0; i < 4; i++) {
            if (isThere(borrower, lender, i)) {
                int point = pointOf(borrower, lender, i);
                double along = along(borrower, point);
                double room = Math.min(along - low, high - along);
                inner = room > most ? point : inner;
                most = Math.max(most, room);
            }
        }
        double share = (along(borrower, inner) - low) / (high - low);
        double[] gap = pairs.separation;
        double between = gap[first] + share * (gap[last] - gap[first]);
        double width = PairTolerances.width(bodies, pairs.bodyA[borrower], pairs.bodyB[borrower]);
        boolean isDeeper = between - gap[inner] > SeamPoint.FLUSH * width;
        int outer = gap[first] > gap[last] ? first : last;
        int removed = isDeeper ? outer : inner;
        pairs.removePoint(removed / 2, removed % 2);
    }

    /** The last of the points in a direction of the line, 1 or −1. */
    private int outermost(int borrower, int lender, int sign) {
        int outermost = Pairs.NONE;
        double farthest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 4; i++) {
            if (isThere(borrower, lender, i)) {
                int point = pointOf(borrower, lender, i);
                double along = sign * along(borrower, point);
                outermost = along > farthest ? point : outermost;
                farthest = Math.max(farthest, along);
            }
        }
        return outermost;
    }

    private boolean isThere(int borrower, int lender, int i) {
        return i % 2 < pairs.points[i < 2 ? borrower : lender];
    }

    private static int pointOf(int borrower, int lender, int i) {
        return 2 * (i < 2 ? borrower : lender) + i % 2;
    }

    private double along(int pair, int point) {
        return pairs.normalX[pair] * pairs.pointY[point]
                - pairs.normalY[pair] * pairs.pointX[point];
    }

    /** Gives all lent points back at the end of the step, with the loads that they carried. */
    void settle() {
        for (int i = 0; i < borrowers.count; i++) {
            settle(borrowers.numbers[i]);
        }
        borrowers.clear();
    }

    private void settle(int borrower) {
        int lender = lenderOf[borrower];
        double all = force(borrower);
        giveBack(borrower);
        lenderOf[borrower] = Pairs.NONE;
        double lent = force(lender);
        double share = all > 0 ? lent / all : 0.5;
        double pushed = pairs.impulse[borrower] - impulseBefore[borrower];
        pairs.impulse[borrower] -= share * pushed;
        pairs.tellImpulse(lender, share * pushed);
        pairs.impacts[lender] += pairs.impacts[borrower] - impactsBefore[borrower];
        pairs.crushed[lender] |= pairs.crushed[borrower];
        if (pairs.frictionForce != null) {
            double friction = pairs.frictionForce[borrower];
            pairs.frictionForce[lender] = share * friction;
            pairs.frictionForce[borrower] = friction - share * friction;
        }
        if (lent > 0) {
            pairs.resting[lender] = true;
            pairs.touching[lender] = true;
        }
    }

    private double force(int pair) {
        return pairs.normalForce[2 * pair] + pairs.normalForce[2 * pair + 1];
    }
}

package rigibo.backend.collision;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * Leaves out contact points of bodies with several parts that lie between two others on one line,
 * or at the place of another. If the two outer points do not overlap, the ones between them do not,
 * either. Any load that all of them can carry together, the two outer ones can carry alone: the
 * inner rows are redundant. So a box of two halves stands on two points, like a box of one piece.
 * With six, the passes would find one of many distributions of the load, and a landing would be
 * resolved part by part.
 */
final class InnerPoints {

    /** Sine of the largest angle between the normals of points on one line. */
    private static final double PARALLEL = 1e-3;

    private static final int FEWEST = 64;

    /** Largest slide in a step, in widths, of two bodies that stand on each other. */
    private static final double HARDLY = 1e-2;

    private final Bodies bodies;
    private final Pairs pairs;
    private final OuterPoints outer;

    /**
     * By hash of two bodies: the first and the last pair found between them, or {@link Pairs#NONE}.
     */
    private int[] firstOf = new int[0];

    private int[] lastOf;
    private int mask;

    /** By pair: the next one between the same two bodies. */
    private int[] after = new int[0];

    /** The first pair of each two bodies with several pairs, in the order of the active pairs. */
    private int[] groups = new int[FEWEST];

    private int groupCount;

    /** The outer points of a point's line, and their distances from the point, m. */
    private int below;

    private int above;
    private double toBelow;
    private double toAbove;

    InnerPoints(DataStorage data, OuterPoints outer) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.outer = outer;
    }

    /**
     * Leaves out the inner points of all active pairs at the start of a step of {@code dt} s. In
     * flight, each of two pairs with a point at the same place keeps its own; otherwise the impact
     * would depend on the order of pairs.
     */
    void leaveOut(double dt) {
        begin(pairs.activeCount);
        for (int i = 0; i < pairs.activeCount; i++) {
            consider(pairs.active[i]);
        }
        leaveOutOfGroups(dt, false);
    }

    /**
     * Leaves out the inner points of all piles, after the flight of a step of {@code dt} s has
     * measured contacts of bodies that joined one and of those beside them; puts the outer two in
     * one pair.
     */
    void leaveOutOfPiles(double dt) {
        begin(pairs.activeCount);
        for (int i = 0; i < pairs.activeCount; i++) {
            int pair = pairs.active[i];
            if (isInPile(pairs.bodyA[pair]) && isInPile(pairs.bodyB[pair])) {
                consider(pair);
            }
        }
        leaveOutOfGroups(dt, true);
        outer.begin();
        for (int i = 0; i < groupCount; i++) {
            lendWithin(groups[i], dt);
        }
    }

    private void lendWithin(int first, double dt) {
        double width = PairTolerances.width(bodies, pairs.bodyA[first], pairs.bodyB[first]);
        for (int pair = first; pair != Pairs.NONE; pair = after[pair]) {
            if (outer.mayTakePart(pair)) {
                int lender = lenderFor(pair, width, dt);
                if (lender != Pairs.NONE) {
                    outer.lend(pair, lender);
                }
            }
        }
    }

    /**
     * The later pair with a single point whose point lies farthest on the line, or {@link
     * Pairs#NONE}. There is none if the bodies slide or turn on each other by more than a little,
     * since then their points do not stay in place in the step.
     */
    private int lenderFor(int pair, double width, double dt) {
        int lender = Pairs.NONE;
        double farthest = SeamPoint.CLOSED * width;
        for (int other = after[pair]; other != Pairs.NONE; other = after[other]) {
            if (outer.mayTakePart(other) && isLike(pair, other)) {
                double along = Math.abs(along(pair, 2 * pair, 2 * other));
                double height = Math.abs(height(pair, 2 * pair, 2 * other));
                if (along > farthest && height <= SeamPoint.FLUSH * width + PARALLEL * along) {
                    farthest = along;
                    lender = other;
                }
            }
        }
        return slide(pair, farthest, dt) <= HARDLY * width ? lender : Pairs.NONE;
    }

    /** Whether two pairs were measured at the same poses of their bodies. */
    private boolean areOfOneTime(int pair, int other) {
        return pairs.middleX[pair] == pairs.middleX[other]
                && pairs.middleY[pair] == pairs.middleY[other];
    }

    private boolean isInPile(int body) {
        return !bodies.isDynamic(body) || bodies.piled[body];
    }

    private void leaveOutOfGroups(double dt, boolean arePiled) {
        for (int i = 0; i < groupCount; i++) {
            leaveOutOfGroup(groups[i], dt, arePiled);
        }
    }

    private void consider(int pair) {
        if (pairs.points[pair] > 0 && isOfParts(pair)) {
            chain(pair);
        }
    }

    private void begin(int count) {
        groupCount = 0;
        int size = Integer.highestOneBit(Math.max(FEWEST, 2 * count) - 1) * 2;
        mask = size - 1;
        if (firstOf.length < size) {
            firstOf = new int[size];
            lastOf = new int[size];
        }
        if (after.length < pairs.room()) {
            after = new int[pairs.room()];
        }
        Arrays.fill(firstOf, 0, size, Pairs.NONE);
    }

    /**
     * Whether one of the bodies moves and has several parts. Edges of chains know their neighbours.
     */
    private boolean isOfParts(int pair) {
        int a = pairs.shapeA(pair);
        int b = pairs.shapeB(pair);
        return (hasParts(pairs.bodyA[pair]) || hasParts(pairs.bodyB[pair]))
                && !bodies.outline[a].isEdge()
                && !bodies.outline[b].isEdge();
    }

    private boolean hasParts(int body) {
        return bodies.isDynamic(body) && bodies.nextShapeOf(body) != Pairs.NONE;
    }

    private void chain(int pair) {
        int at = hash(pairs.bodyA[pair], pairs.bodyB[pair]) & mask;
        while (firstOf[at] != Pairs.NONE && !areOfTheSame(firstOf[at], pair)) {
            at = at + 1 & mask;
        }
        after[pair] = Pairs.NONE;
        if (firstOf[at] == Pairs.NONE) {
            firstOf[at] = pair;
        } else {
            if (lastOf[at] == firstOf[at]) {
                addGroup(firstOf[at]);
            }
            after[lastOf[at]] = pair;
        }
        lastOf[at] = pair;
    }

    private static int hash(int a, int b) {
        int mixed = a * 0x9E3779B1 + b * 0x85EBCA77;
        return mixed ^ mixed >>> 15;
    }

    private boolean areOfTheSame(int pair, int other) {
        return pairs.bodyA[pair] == pairs.bodyA[other] && pairs.bodyB[pair] == pairs.bodyB[other];
    }

    private void addGroup(int first) {
        if (groupCount == groups.length) {
            groups = Arrays.copyOf(groups, 2 * groupCount);
        }
        groups[groupCount++] = first;
    }

    private void leaveOutOfGroup(int first, double dt, boolean arePiled) {
        double width = PairTolerances.width(bodies, pairs.bodyA[first], pairs.bodyB[first]);
        for (int pair = first; pair != Pairs.NONE; pair = after[pair]) {
            for (int i = pairs.points[pair] - 1; i >= 0; i--) {
                findOuter(first, pair, 2 * pair + i);
                double away = SeamPoint.FLUSH * width + slide(pair, toBelow + toAbove, dt);
                int twin = arePiled ? twinOf(first, pair, 2 * pair + i, width, away) : Pairs.NONE;
                if (twin != Pairs.NONE) {
                    handOver(2 * pair + i, twin, 1);
                    remove(pair, i);
                } else if (isInner(pair, 2 * pair + i, width, away)) {
                    double share = toBelow / (toBelow + toAbove);
                    handOver(2 * pair + i, above, share);
                    handOver(2 * pair + i, below, 1 - share);
                    remove(pair, i);
                }
            }
        }
    }

    /**
     * Whether a point is redundant: it lies between the outer two, more than {@code away} m from
     * both, the distance by which it may slide in the step, and is not deeper than the line through
     * them.
     */
    private boolean isInner(int pair, int point, double width, double away) {
        if (below == Pairs.NONE || above == Pairs.NONE || !(Math.min(toBelow, toAbove) > away)) {
            return false;
        }
        double share = toBelow / (toBelow + toAbove);
        double between = pairs.separation[below];
        between += share * (pairs.separation[above] - between);
        double deeper = between - pairs.separation[point];
        double height = height(pair, point, below);
        height += share * (height(pair, point, above) - height);
        return deeper <= SeamPoint.FLUSH * width
                && Math.abs(height) <= SeamPoint.FLUSH * width + Math.abs(deeper);
    }

    /** Finds the points farthest from a point in both directions along its surface. */
    private void findOuter(int first, int pair, int point) {
        below = Pairs.NONE;
        above = Pairs.NONE;
        toBelow = 0;
        toAbove = 0;
        for (int other = first; other != Pairs.NONE; other = after[other]) {
            for (int q = 2 * other; q < 2 * other + pairs.points[other]; q++) {
                double along = along(pair, point, q);
                if (along < -toBelow && isLike(pair, other)) {
                    toBelow = -along;
                    below = q;
                } else if (along > toAbove && isLike(pair, other)) {
                    toAbove = along;
                    above = q;
                }
            }
        }
    }

    private double along(int pair, int from, int to) {
        return pairs.normalX[pair] * (pairs.pointY[to] - pairs.pointY[from])
                - pairs.normalY[pair] * (pairs.pointX[to] - pairs.pointX[from]);
    }

    private double height(int pair, int from, int to) {
        return pairs.normalX[pair] * (pairs.pointX[to] - pairs.pointX[from])
                + pairs.normalY[pair] * (pairs.pointY[to] - pairs.pointY[from]);
    }

    /**
     * Whether two pairs were measured at the same poses and have one normal and equal friction and
     * elasticity.
     */
    private boolean isLike(int pair, int other) {
        double nx = pairs.normalX[pair];
        double ny = pairs.normalY[pair];
        double mx = pairs.normalX[other];
        double my = pairs.normalY[other];
        return areOfOneTime(pair, other)
                && nx * mx + ny * my > 0
                && Math.abs(nx * my - ny * mx) <= PARALLEL
                && pairs.frictionOf(pair) == pairs.frictionOf(other)
                && pairs.elasticityOf(pair) == pairs.elasticityOf(other)
                && runAlike(pair, other);
    }

    private boolean runAlike(int pair, int other) {
        return (bodies.surfaceSpeed == null
                        || pairs.surfaceSpeed(bodies, pair) == pairs.surfaceSpeed(bodies, other))
                && (bodies.rollingResistance == null
                        || pairs.rollingLever(bodies, pair) == pairs.rollingLever(bodies, other))
                && (pairs.passage == null || pairs.passage[pair] == pairs.passage[other]);
    }

    /** Distance in m by which the bodies may slide over each other in the step. */
    private double slide(int pair, double span, double dt) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double nx = pairs.normalX[pair];
        double ny = pairs.normalY[pair];
        double speed =
                nx * (bodies.velocityY[b] - bodies.velocityY[a])
                        - ny * (bodies.velocityX[b] - bodies.velocityX[a]);
        double turning = bodies.turns() ? Math.abs(bodies.spin[b]) + Math.abs(bodies.spin[a]) : 0;
        return (Math.abs(speed) + turning * span) * dt;
    }

    /**
     * Finds a point of another pair at the same place, where edges of two parts end. The pair with
     * more points keeps its point, or else the earlier one: a part that only ends there may be left
     * out as covered when it is measured again. Both pairs keep theirs if an outer point is within
     * {@code away} m, past which they may slide in the step: then one pair loses its point, and it
     * is not known beforehand which.
     */
    private int twinOf(int first, int pair, int point, double width, double away) {
        double same = SeamPoint.FLUSH * width;
        if (toBelow > same && toBelow <= away || toAbove > same && toAbove <= away) {
            return Pairs.NONE;
        }
        boolean isEarlier = true;
        for (int other = first; other != Pairs.NONE; other = after[other]) {
            isEarlier &= other != pair;
            boolean hasMore = pairs.points[other] > pairs.points[pair];
            if (other != pair && (isEarlier || hasMore)) {
                for (int q = 2 * other; q < 2 * other + pairs.points[other]; q++) {
                    if (Math.abs(along(pair, point, q)) <= same
                            && Math.abs(height(pair, point, q)) <= same
                            && isLike(pair, other)) {
                        return q;
                    }
                }
            }
        }
        return Pairs.NONE;
    }

    private void remove(int pair, int i) {
        int point = 2 * pair + i;
        double x = pairs.pointX[point];
        double y = pairs.pointY[point];
        pairs.removePoint(pair, i);
        if (pairs.points[pair] == 0) {
            // The report gives this place for the contact.
            pairs.pointX[2 * pair] = x;
            pairs.pointY[2 * pair] = y;
        }
    }

    /** Adds a share of a point's forces to another one; by the law of the lever, to two. */
    private void handOver(int from, int to, double share) {
        pairs.normalForce[to] += share * pairs.normalForce[from];
        pairs.load[to] += share * pairs.load[from];
    }
}

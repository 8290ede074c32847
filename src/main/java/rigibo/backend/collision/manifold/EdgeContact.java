package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.RoundOff;

/**
 * Manifold of an edge of a chain, as A, and any outline, as B. An edge pushes along its normal, if
 * a corner of B lies over it or B lies flat on it. A convex corner between two edges pushes along
 * the normals between theirs; the edge that ends there reports its contact. There are no other
 * contacts: in every other direction, the feature nearest to the end of an edge faces the matter of
 * the next edge. So a body does not catch on a corner that it slides over.
 */
public final class EdgeContact {

    /**
     * Largest overlap, per metre of the outline, of a body that rests beside an edge and is about
     * to come over it.
     */
    private static final double SLACK = 1e-2;

    private static final int CUT = 1 << 16;
    private static final int CORNER = 1 << 17;

    private final EdgeView view = new EdgeView();

    /** Corner numbers of the lowest side of the core, left end first. */
    private int left;

    private int right;
    private boolean isFlat;

    /** Gaps of the edge's own contact and of a corner's, m; infinite if there is none. */
    private double gapOfFace;

    private double gapOfCorner;
    private boolean isCornerAtStart;

    /** Overlap in m up to which a body beside the edge may meet the edge's plane. */
    private double slack;

    /** The corner nearest to the edge among those over or under it. */
    private int nearestOver;

    /** Writes the contact points within a reach, in m. */
    void collide(Outline edge, Pose poseE, Outline other, Pose poseO, double reach, Manifold out) {
        double width = other.isEdge() ? 0 : other.smallestWidth();
        slack = SLACK * width;
        view.look(edge, poseE, other, poseO, RoundOff.OF_PLACES * width);
        double radius = other.radius();
        if (view.least - radius > reach || view.most + radius <= 0) {
            return;
        }
        findSide();
        gapOfFace = faceGap(radius);
        if (gapOfFace < 0 && isBehindRidge(radius)) {
            gapOfFace = Double.POSITIVE_INFINITY;
        }
        gapOfCorner = Double.POSITIVE_INFINITY;
        if (!(isFlat && gapOfFace < Double.POSITIVE_INFINITY)) {
            findCorner(true, radius);
            findCorner(false, radius);
        }
        if (isCorner() && !isOwn(isCornerAtStart)) {
            writeBesideCorner(poseE, radius, reach, out);
        } else if (isCorner()) {
            writeCorner(poseE, radius, reach, out);
        } else if (gapOfFace < Double.POSITIVE_INFINITY) {
            writeFace(poseE, radius, reach, out);
        } else {
            writeAhead(poseE, radius, reach, out);
        }
        if (out.count == 0) {
            await(poseE, radius, reach, out);
        }
    }

    /**
     * Records the gap to a body that may come over this edge within the step: it is over no edge
     * yet, or over another one.
     */
    private void await(Pose pose, double radius, double reach, Manifold out) {
        if (view.leastDistance() - radius > reach) {
            return;
        }
        double gap = Math.max(0, distanceOfCore() - radius);
        if (gap <= reach) {
            view.normal(pose, 0, 1, NormalSource.FACE_A, out);
            out.beside = gap;
        }
    }

    /**
     * Whether the corner is the contact. If both features overlap, it is the one that overlaps
     * less, otherwise the nearer one.
     */
    private boolean isCorner() {
        boolean areBothIn = gapOfCorner <= 0 && gapOfFace <= 0;
        return areBothIn ? gapOfCorner > gapOfFace : gapOfCorner < gapOfFace;
    }

    /**
     * Finds the side of the core that faces the edge most: one of the two sides at its lowest
     * corner.
     */
    private void findSide() {
        int at = view.lowest;
        int before = at == 0 ? view.corners - 1 : at - 1;
        int after = at + 1 == view.corners ? 0 : at + 1;
        boolean isBefore = facing(before, at) > facing(at, after);
        left = isBefore ? before : at;
        right = isBefore ? at : after;
        double rise = Math.abs(view.above[right] - view.above[left]);
        isFlat = view.corners > 1 && rise <= EdgeView.FLAT * (view.along[right] - view.along[left]);
    }

    private double facing(int from, int to) {
        double x = view.along[to] - view.along[from];
        double y = view.above[to] - view.above[from];
        return x / Math.sqrt(x * x + y * y);
    }

    private double faceGap(double radius) {
        double least = Double.POSITIVE_INFINITY;
        if (view.isOver(left)) {
            least = view.above[left];
        }
        if (view.isOver(right)) {
            least = Math.min(least, view.above[right]);
        }
        if (isFlat && isAcross()) {
            least = Math.min(least, Math.min(aboveEnd(-view.half), aboveEnd(view.half)));
        }
        return least - radius;
    }

    /**
     * Whether an outline that reaches below the edge's plane lies against the other flank of a
     * ridge, so that the edge's normal would lead it through the ridge. Such an outline does not
     * touch the edge, or touches only its end, out of which the shortest way leads to the other
     * flank.
     */
    private boolean isBehindRidge(double radius) {
        if (!view.isConvex(true) && !view.isConvex(false)) {
            return false;
        }
        boolean isPierced = view.isPierced();
        if (!isPierced && distanceOfCore() > radius) {
            return true;
        }
        boolean isCrossed = isPierced && view.corners == 2;
        return !isCrossed && (leadsBeyond(true, radius) || leadsBeyond(false, radius));
    }

    private boolean leadsBeyond(boolean isStart, double radius) {
        return view.isConvex(isStart)
                && view.leadsBeyond(isStart)
                && view.distance - radius > gapOfFace + slack;
    }

    /** Distance between the core and the edge, m; 0 if an end of the edge is inside the core. */
    private double distanceOfCore() {
        view.lookFrom(true);
        double fromStart = view.distance;
        boolean isIn = view.isInside;
        view.lookFrom(false);
        double fromEnds = Math.min(fromStart, view.distance);
        return isIn || view.isInside ? 0 : Math.min(nearestOver(), fromEnds);
    }

    /** Whether a part of the lowest side, not only one point, lies over the edge. */
    private boolean isAcross() {
        return view.along[left] < view.half && view.along[right] > -view.half;
    }

    /**
     * Height of the lowest side over an end of the edge, or at its own end if that comes first, m.
     */
    private double aboveEnd(double end) {
        double length = view.along[right] - view.along[left];
        double share = Math.max(0, Math.min(1, (end - view.along[left]) / length));
        return view.above[left] + share * (view.above[right] - view.above[left]);
    }

    private void findCorner(boolean isStart, double radius) {
        if (!view.isConvex(isStart)) {
            return;
        }
        view.lookFrom(isStart);
        double gap = view.distance - radius;
        boolean isPushing =
                view.distance > Double.NEGATIVE_INFINITY
                        && view.mayPush(isStart, view.directionX, view.directionY);
        if (isPushing && gap < gapOfCorner) {
            gapOfCorner = gap;
            isCornerAtStart = isStart;
        }
    }

    /**
     * Whether this edge reports the corner: the edge that ends there does, or the first edge of an
     * open chain.
     */
    private boolean isOwn(boolean isStart) {
        return !isStart || view.beyond(true).isOpen();
    }

    /**
     * Writes the edge's own contact beside a corner that the previous edge reports, since a body
     * that turns about this corner comes to lie on the edge. At a sharp ridge the edge's normal may
     * not lead out; so no contact is written if the core lies deeper beyond the corner than over
     * the edge, or deeper over the edge than the corner lies in it.
     */
    private void writeBesideCorner(Pose pose, double radius, double reach, Manifold out) {
        boolean isShallow = gapOfFace >= gapOfCorner - slack;
        boolean leadsOut = gapOfFace > 0 || isShallow && view.leastBeyond(true) >= view.leastOver;
        if (gapOfFace < Double.POSITIVE_INFINITY && leadsOut) {
            writeFace(pose, radius, reach, out);
        }
    }

    private void writeCorner(Pose pose, double radius, double reach, Manifold out) {
        if (gapOfCorner <= reach) {
            addCorner(pose, isCornerAtStart, radius, out);
            // A side that lies on the other flank of a ridge does not end over this edge.
            if (view.isOfFace && view.directionY > 0) {
                addFarEnd(pose, radius, reach, out);
            }
        }
    }

    /**
     * Adds the other end of the overlap between a side of the core and the edge, if there is one.
     */
    private void addFarEnd(Pose pose, double radius, double reach, Manifold out) {
        int corner = isCornerAtStart ? view.sideLeft() : view.sideRight();
        double end = view.end(!isCornerAtStart);
        if (view.isOver(corner)) {
            double gap = view.above[corner] - radius;
            if (gap <= reach) {
                view.add(pose, view.along[corner], gap / 2, gap, corner, out);
            }
        } else if (isCornerAtStart ? view.along[corner] < end : view.along[corner] > end) {
            double gap =
                    view.directionX * (view.along[corner] - end)
                            + view.directionY * view.above[corner]
                            - radius;
            if (gap <= reach) {
                view.add(pose, end, gap / 2, gap, CORNER | (isCornerAtStart ? 0 : 1), out);
            }
        }
    }

    private void addCorner(Pose pose, boolean isStart, double radius, Manifold out) {
        view.lookFrom(isStart);
        double gap = view.distance - radius;
        NormalSource source = view.isOfFace ? NormalSource.FACE_B : NormalSource.CLOSEST_POINTS;
        view.normal(pose, view.directionX, view.directionY, source, out);
        double s = view.end(isStart) + view.directionX * gap / 2;
        view.add(pose, s, view.directionY * gap / 2, gap, CORNER | (isStart ? 1 : 0), out);
    }

    private void writeFace(Pose pose, double radius, double reach, Manifold out) {
        view.normal(pose, 0, 1, NormalSource.FACE_A, out);
        boolean isCut = left != right && isAcross();
        addEnd(pose, left, -view.half, isCut, radius, reach, out);
        if (right != left) {
            addEnd(pose, right, view.half, isCut, radius, reach, out);
        }
    }

    /** Adds an end of the lowest side, or the end of the edge that cuts it off. */
    private void addEnd(
            Pose pose,
            int corner,
            double end,
            boolean isCut,
            double radius,
            double reach,
            Manifold out) {
        if (view.isOver(corner)) {
            double gap = view.above[corner] - radius;
            if (gap <= reach) {
                view.add(pose, view.along[corner], gap / 2, gap, corner, out);
            }
        } else if (isCut) {
            double gap = aboveEnd(end) - radius;
            if (gap <= reach) {
                view.add(pose, end, gap / 2, gap, CUT | (end > 0 ? 1 : 0), out);
            }
        }
    }

    /**
     * Writes the contact with an edge that rises or goes straight on, for a body that is still over
     * the edge before it but meets this one within the step. Between the two, this edge's plane
     * lies on the matter or inside it.
     */
    private void writeAhead(Pose pose, double radius, double reach, Manifold out) {
        view.normal(pose, 0, 1, NormalSource.FACE_A, out);
        addAhead(pose, isFlat ? left : view.lowest, radius, reach, out);
        if (isFlat) {
            addAhead(pose, right, radius, reach, out);
        }
    }

    private void addAhead(Pose pose, int corner, double radius, double reach, Manifold out) {
        double gap = view.above[corner] - radius;
        double s = view.along[corner];
        boolean isStart = s > 0;
        double beside = Math.abs(s) - view.half;
        boolean isNear =
                !view.isConvex(isStart) && beside <= Math.min(reach, view.beyond(isStart).run());
        if (isNear && gap >= -slack && gap <= reach) {
            view.add(pose, s, gap / 2, gap, corner, out);
        }
    }

    /**
     * Writes the nearest points, for the distance. An edge counts as a line with two sides, until a
     * body comes within {@code near} m of an end from a direction in which that end does not push;
     * then the edge's normal counts.
     */
    void distance(Outline edge, Pose poseE, Outline other, Pose poseO, double near, Manifold out) {
        view.look(edge, poseE, other, poseO, 0);
        double radius = other.radius();
        findSide();
        view.lookFrom(true);
        double fromStart = view.distance;
        boolean isIn = view.isInside;
        view.lookFrom(false);
        double fromEnd = view.distance;
        isIn |= view.isInside || view.isPierced();
        if (isIn) {
            writeOverlap(poseE, radius, out);
            return;
        }
        double toSide = nearestOver();
        boolean isStart = fromStart < fromEnd;
        double toEnd = Math.min(fromStart, fromEnd);
        if (toSide <= toEnd) {
            writeSide(poseE, radius, out);
            return;
        }
        view.lookFrom(isStart);
        boolean isPushing = view.mayPush(isStart, view.directionX, view.directionY);
        if (isPushing || toEnd - radius > near) {
            addCorner(poseE, isStart, radius, out);
        } else {
            writePlane(poseE, radius, out);
        }
    }

    private double nearestOver() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < view.corners; i++) {
            if (view.isOver(i) && Math.abs(view.above[i]) < least) {
                least = Math.abs(view.above[i]);
                nearestOver = i;
            }
        }
        return least;
    }

    /**
     * Writes the nearest points where the two are apart and a corner over or under the edge is
     * nearest.
     */
    private void writeSide(Pose pose, double radius, Manifold out) {
        boolean isOfSide = nearestOver == left || nearestOver == right;
        if (isOfSide && view.above[nearestOver] > 0) {
            writeFace(pose, radius, Double.POSITIVE_INFINITY, out);
            return;
        }
        double sign = view.above[nearestOver] > 0 ? 1 : -1;
        double gap = sign * view.above[nearestOver] - radius;
        view.normal(pose, 0, sign, NormalSource.FACE_A, out);
        double h = sign * gap / 2;
        view.add(pose, view.along[nearestOver], h, gap, nearestOver, out);
    }

    private void writeOverlap(Pose pose, double radius, Manifold out) {
        gapOfCorner = Double.NEGATIVE_INFINITY;
        for (int end = 0; end < 2; end++) {
            boolean isStart = end == 0;
            view.lookFrom(isStart);
            boolean isPushing =
                    view.distance > Double.NEGATIVE_INFINITY
                            && view.mayPush(isStart, view.directionX, view.directionY);
            if (isPushing && view.isInside && view.distance > gapOfCorner) {
                gapOfCorner = view.distance;
                isCornerAtStart = isStart;
            }
        }
        if (gapOfCorner > view.least) {
            addCorner(pose, isCornerAtStart, radius, out);
        } else {
            writePlane(pose, radius, out);
        }
    }

    /** Writes the lowest corner's distance along the edge's normal, wherever that corner is. */
    private void writePlane(Pose pose, double radius, Manifold out) {
        double gap = view.least - radius;
        view.normal(pose, 0, 1, NormalSource.FACE_A, out);
        view.add(pose, view.along[view.lowest], gap / 2, gap, view.lowest, out);
    }

    /** The side of the chain on which a core lies, or ACROSS if it reaches into the edge. */
    public Side side(Outline edge, Pose poseE, Outline other, Pose poseO) {
        view.look(edge, poseE, other, poseO, 0);
        view.lookFrom(true);
        double fromStart = view.distance;
        double startX = view.directionX;
        double startY = view.directionY;
        boolean isIn = view.isInside;
        view.lookFrom(false);
        double nearest = Math.min(nearestOver(), Math.min(fromStart, view.distance));
        isIn |= view.isInside || view.isPierced() || nearest <= other.radius();
        if (isIn) {
            return Side.ACROSS;
        }
        if (nearestOver() <= nearest) {
            return view.most > 0 ? Side.AIR : Side.MATTER;
        }
        boolean isStart = fromStart < view.distance;
        double x = isStart ? startX : view.directionX;
        double y = isStart ? startY : view.directionY;
        return view.isInAir(isStart, x, y) || isCentreInAir() ? Side.AIR : Side.MATTER;
    }

    /** Whether the mean of the corners of the core measured last lies in the air. */
    public boolean isCentreInAir() {
        double s = view.centreAlong();
        double h = view.centreAbove();
        if (Math.abs(s) <= view.half) {
            return h > 0;
        }
        boolean isStart = s > 0;
        return view.isInAir(isStart, s - view.end(isStart), h);
    }

    /** Position of an outline relative to a chain. */
    public enum Side {
        AIR,
        MATTER,
        /** On both sides, or touching. */
        ACROSS
    }
}

package rigibo.backend.collision;

import rigibo.backend.geometry.Outline;

/**
 * Manifold of an edge of a chain, as A, and any outline. An edge pushes along its normal what has a
 * corner over it or lies flat on it. A corner of matter between two edges pushes along the normals
 * between theirs, and the edge that ends there tells of it. Nothing else is a contact: what is
 * nearest to the end of an edge in any other direction is the next edge's matter. So nothing bumps
 * into a corner that it slides over.
 */
final class EdgeContact {

    /** Round-off of a place over the edge, per metre of what touches it. */
    private static final double ROUND_OFF = 1e-9;

    /** Overlap, likewise, of what rests beside an edge and is about to come over it. */
    private static final double SLACK = 1e-2;

    private static final int CUT = 1 << 16;
    private static final int CORNER = 1 << 17;

    private final EdgeView view = new EdgeView();

    /** The ends of the core's lowest side, the left one first, by the numbers of their corners. */
    private int left;

    private int right;
    private boolean isFlat;

    /** The gap in m of the edge's own contact, and of that of a corner; infinite without. */
    private double gapOfFace;

    private double gapOfCorner;
    private boolean isCornerAtStart;

    /** Overlap in m beside the edge with which its plane may be met. */
    private double slack;

    /** The corner nearest to the edge of those that lie over or under it. */
    private int nearestOver;

    /** Writes the points of contact that are no farther than a reach; returns how many. */
    int collide(Outline edge, Pose poseE, Outline other, Pose poseO, double reach, Manifold out) {
        double width = other.isEdge() ? 0 : other.smallestWidth();
        slack = SLACK * width;
        view.look(edge, poseE, other, poseO, ROUND_OFF * width);
        double radius = other.radius();
        if (view.least - radius > reach || view.most + radius <= 0) {
            return 0;
        }
        findSide();
        gapOfFace = faceGap(radius);
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
        return out.count;
    }

    /** What is over no edge yet, or over another one, may come over this one within the step. */
    private void await(Pose pose, double radius, double reach, Manifold out) {
        if (view.leastDistance() - radius > reach) {
            return;
        }
        view.lookFrom(true);
        double toEnds = view.distance;
        boolean isIn = view.isInside;
        view.lookFrom(false);
        isIn |= view.isInside;
        double nearest = Math.min(nearestOver(), Math.min(toEnds, view.distance));
        double gap = isIn ? 0 : Math.max(0, nearest - radius);
        if (gap <= reach) {
            view.normal(pose, 0, 1, NormalSource.FACE_A, out);
            out.beside = gap;
        }
    }

    /** Of two that overlap the one that overlaps less is it, else the nearer one. */
    private boolean isCorner() {
        boolean areBothIn = gapOfCorner <= 0 && gapOfFace <= 0;
        return areBothIn ? gapOfCorner > gapOfFace : gapOfCorner < gapOfFace;
    }

    /** Finds the side of the core that faces the edge most: one of the two at its lowest corner. */
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

    /** Whether a stretch of the lowest side, not only a point, lies over the edge. */
    private boolean isAcross() {
        return view.along[left] < view.half && view.along[right] > -view.half;
    }

    /** How high the lowest side is over an end of the edge, or at its own end before that, m. */
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

    /** The edge that ends in a corner tells of it, and one that begins where nothing ends. */
    private boolean isOwn(boolean isStart) {
        return !isStart || view.beyond(true).isOpen();
    }

    /**
     * What turns about the corner before the edge comes to lie on the edge itself. Where the core
     * lies deeper beyond the corner than over the edge, the edge's normal does not lead out.
     */
    private void writeBesideCorner(Pose pose, double radius, double reach, Manifold out) {
        boolean leadsOut = gapOfFace > 0 || view.leastBeyond(true) >= view.leastOver;
        if (gapOfFace < Double.POSITIVE_INFINITY && leadsOut) {
            writeFace(pose, radius, reach, out);
        }
    }

    private void writeCorner(Pose pose, double radius, double reach, Manifold out) {
        if (gapOfCorner <= reach) {
            addCorner(pose, isCornerAtStart, radius, out);
            if (view.isOfFace) {
                addFarEnd(pose, radius, reach, out);
            }
        }
    }

    /** The other end of what a side of the core and the edge have in common, if there is one. */
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

    /** An end of the lowest side, or where the edge's own end cuts it off. */
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
     * What comes to an edge that rises, or goes straight on, meets it within the step, though it is
     * over the edge before it yet: there the plane goes on, on the matter or inside it.
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
     * Writes the nearest points, for the distance: as of a line with two sides, until it is as near
     * as {@code near} m to an end along a direction in which that does not push; then the edge's
     * normal counts.
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

    /** Apart, with a corner over or under the edge nearest. */
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

    /** As seen along the edge's normal, wherever the lowest corner is. */
    private void writePlane(Pose pose, double radius, Manifold out) {
        double gap = view.least - radius;
        view.normal(pose, 0, 1, NormalSource.FACE_A, out);
        view.add(pose, view.along[view.lowest], gap / 2, gap, view.lowest, out);
    }

    /** Which side of the chain a core is on that does not reach into the edge. */
    Side side(Outline edge, Pose poseE, Outline other, Pose poseO) {
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

    /** Whether the middle of the core last looked at is on the side of the air. */
    boolean isCentreInAir() {
        double s = view.centreAlong();
        double h = view.centreAbove();
        if (Math.abs(s) <= view.half) {
            return h > 0;
        }
        boolean isStart = s > 0;
        return view.isInAir(isStart, s - view.end(isStart), h);
    }

    /** Where something is, seen from a chain. */
    enum Side {
        AIR,
        MATTER,
        /** On both, or touching. */
        ACROSS
    }
}

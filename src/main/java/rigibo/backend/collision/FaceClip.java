package rigibo.backend.collision;

import rigibo.backend.geometry.Outline;

/**
 * Clips the edge of one polygon to the extent of the other's reference face. All lengths are in the
 * reference polygon's frame; what concerns one end of the face is measured from that end by itself,
 * so that a mirrored scene gives the mirrored bits.
 */
final class FaceClip {

    /**
     * Two corners closer along the face than this, per metre of the narrower polygon, count as one
     * and the point is named after A's: in a stack of equal boxes round-off decides which of the
     * two lies inside. Not a round number, so that no scene built on a grid sits on the limit.
     */
    private static final double SAME_PLACE = 0.0137;

    /**
     * How far beside a face, likewise, the corner of an edge may lie that faces it flat: a box that
     * stands a little in the floor is still before the whole of a wall. The gap is then wrong by
     * less than half of this times the tilt.
     */
    private static final double BESIDE = 1e-5;

    /** Of places that the width of a face does not resolve, per such a width. */
    private static final double ROUND_OFF = 1e-9;

    /** Tilt up to which an edge faces a face flat, rad. */
    private static final double FLAT = 1e-4;

    /**
     * Cosine of the angle between a face's normal and the line between two corners from which on
     * the other end of the face is a point along that line, too. Beyond, 26°, that line tells
     * little of how it lands.
     */
    private static final double NEARLY_ALONG = 0.9;

    private static final int OF_B = 1 << 16;
    private static final int OF_BOTH = 1 << 17;

    /** The reference face: its number, outward normal, start and end. */
    private int face;

    private int faceEnd;
    private double normalX;
    private double normalY;
    private double startX;
    private double startY;
    private double endX;
    private double endY;

    /** The incident edge: it runs against the face, so its end lies at the face's start. */
    private int edge;

    private int edgeEnd;
    private double lowX;
    private double lowY;
    private double highX;
    private double highY;

    /** How far inside the face's start the edge's ends lie along the face, and inside its end. */
    private double lowFromStart;

    private double highFromStart;
    private double lowFromEnd;
    private double highFromEnd;

    private double separation;
    private boolean isLowNearest;
    private double samePlace;

    /** The greater of the two cores' numbers of edges. */
    private int edgesInAll;

    private double beside;

    /** Where the closest features are two corners: which of the face, and which of the edge. */
    private boolean isBetweenCorners;

    private boolean isAtStart;
    private boolean isLowClosest;

    /**
     * Takes the face that a search found and the edge of the other polygon, which sits at a place
     * in the reference's frame, that faces it most.
     */
    void reference(Outline polygon, FaceSearch found, Outline other, Pose place, double width) {
        face = found.face;
        faceEnd = face + 1 == polygon.corners() ? 0 : face + 1;
        normalX = polygon.normalX(face);
        normalY = polygon.normalY(face);
        startX = polygon.cornerX(face);
        startY = polygon.cornerY(face);
        endX = polygon.cornerX(faceEnd);
        endY = polygon.cornerY(faceEnd);
        separation = found.separation;
        samePlace = SAME_PLACE * width;
        edgesInAll = Math.max(polygon.corners(), other.corners());
        chooseEdge(other, found.corner, place);
        placeEdge(other, place);
        boolean isFlat =
                Math.abs(height(highX - lowX, highY - lowY))
                        <= FLAT * Math.abs(alongFace(highX - lowX, highY - lowY));
        beside = isFlat && isOverlapping() ? BESIDE * width : 0;
        isBetweenCorners = findCorners();
    }

    private void chooseEdge(Outline other, int corner, Pose place) {
        double x = place.cos * normalX + place.sin * normalY;
        double y = place.cos * normalY - place.sin * normalX;
        int last = other.corners() - 1;
        int before = corner == 0 ? last : corner - 1;
        int after = corner == last ? 0 : corner + 1;
        double facingBefore = x * other.normalX(before) + y * other.normalY(before);
        double facingAfter = x * other.normalX(corner) + y * other.normalY(corner);
        isLowNearest = facingBefore < facingAfter;
        if (facingBefore == facingAfter) {
            // On its corner at 45° either edge faces as much: the shorter rises less, and choosing
            // by that gives a mirrored scene the mirrored edge.
            isLowNearest =
                    x * other.cornerX(before) + y * other.cornerY(before)
                            < x * other.cornerX(after) + y * other.cornerY(after);
        }
        edge = isLowNearest ? before : corner;
        edgeEnd = isLowNearest ? corner : after;
    }

    private void placeEdge(Outline other, Pose place) {
        double x = other.cornerX(edge);
        double y = other.cornerY(edge);
        highX = place.x + (place.cos * x - place.sin * y);
        highY = place.y + (place.sin * x + place.cos * y);
        x = other.cornerX(edgeEnd);
        y = other.cornerY(edgeEnd);
        lowX = place.x + (place.cos * x - place.sin * y);
        lowY = place.y + (place.sin * x + place.cos * y);
        lowFromStart = alongFace(lowX - startX, lowY - startY);
        highFromStart = alongFace(highX - startX, highY - startY);
        lowFromEnd = -alongFace(lowX - endX, lowY - endY);
        highFromEnd = -alongFace(highX - endX, highY - endY);
    }

    private double alongFace(double x, double y) {
        return normalX * y - normalY * x;
    }

    private double height(double x, double y) {
        return normalX * x + normalY * y;
    }

    /**
     * Whether the polygons are apart and the two closest points are corners: the nearest corner
     * lies beside the face, and the face's own corner does not lie over the inside of the edge.
     */
    private boolean findCorners() {
        // A core of two corners has no face across its own line: two in one line are apart though
        // no face parts them.
        boolean mayBeInLine = edgesInAll == 2 && separation > -ROUND_OFF * samePlace;
        if (!(separation > 0 || mayBeInLine)) {
            return false;
        }
        boolean isBeyondStart = (isLowNearest ? lowFromStart : highFromStart) < -beside;
        boolean isBeyondEnd = (isLowNearest ? lowFromEnd : highFromEnd) < -beside;
        if (!(isBeyondStart || isBeyondEnd)) {
            return false;
        }
        double alongX = highX - lowX;
        double alongY = highY - lowY;
        double x = isBeyondStart ? startX : endX;
        double y = isBeyondStart ? startY : endY;
        double pastLow = (x - lowX) * alongX + (y - lowY) * alongY;
        double pastHigh = (highX - x) * alongX + (highY - y) * alongY;
        isAtStart = isBeyondStart;
        isLowClosest = pastLow < pastHigh;
        return !isOverlapping() || pastLow <= 0 || pastHigh <= 0;
    }

    private boolean isOverlapping() {
        return highFromStart > 0 && lowFromEnd > 0;
    }

    /** Writes the manifold with the reference polygon at a pose; returns its number of points. */
    int write(Pose pose, NormalSource source, double reach, Manifold out) {
        if (isBetweenCorners) {
            writeCorners(pose, source, reach, out);
        } else if (isOverlapping()) {
            writeEnds(pose, source, reach, out);
        } else {
            writeNearest(pose, source, out);
        }
        if (source == NormalSource.FACE_B) {
            out.normalX = -out.normalX;
            out.normalY = -out.normalY;
        }
        return out.count;
    }

    /**
     * The two corners that are nearest, and the far end of the stretch where edge and face overlap:
     * cores with a radius stay apart, so that their corners may be nearest until the moment when
     * that end lands.
     */
    private void writeCorners(Pose pose, NormalSource source, double reach, Manifold out) {
        double fromX = isAtStart ? startX : endX;
        double fromY = isAtStart ? startY : endY;
        double dx = (isLowClosest ? lowX : highX) - fromX;
        double dy = (isLowClosest ? lowY : highY) - fromY;
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance > reach) {
            return;
        }
        out.normal(dx / distance, dy / distance, NormalSource.CLOSEST_POINTS);
        out.turn(pose);
        int own = isAtStart ? face : faceEnd;
        int others = isLowClosest ? edgeEnd : edge;
        int name = source == NormalSource.FACE_A ? own | others << 8 : others | own << 8;
        addPoint(pose, fromX + dx / 2, fromY + dy / 2, distance, OF_BOTH | name, out);
        double along = normalX * dx + normalY * dy;
        if (isOverlapping() && along > NEARLY_ALONG * distance) {
            if (isAtStart) {
                writeHighEnd(pose, source, reach, out);
            } else {
                writeLowEnd(pose, source, reach, out);
            }
        }
    }

    /** Both ends of the stretch where edge and face overlap, A's start of its face first. */
    private void writeEnds(Pose pose, NormalSource source, double reach, Manifold out) {
        out.normal(normalX, normalY, source);
        out.turn(pose);
        if (source == NormalSource.FACE_A) {
            writeLowEnd(pose, source, reach, out);
            writeHighEnd(pose, source, reach, out);
        } else {
            writeHighEnd(pose, source, reach, out);
            writeLowEnd(pose, source, reach, out);
        }
    }

    private void writeLowEnd(Pose pose, NormalSource source, double reach, Manifold out) {
        double cut = lowFromStart < 0 ? -lowFromStart / (highFromStart - lowFromStart) : 0;
        double x = lowX + (highX - lowX) * cut;
        double y = lowY + (highY - lowY) * cut;
        int name = name(source, lowFromStart, face, edgeEnd);
        addFacing(pose, x, y, height(x - startX, y - startY), reach, name, out);
    }

    private void writeHighEnd(Pose pose, NormalSource source, double reach, Manifold out) {
        double cut = highFromEnd < 0 ? -highFromEnd / (lowFromEnd - highFromEnd) : 0;
        double x = highX + (lowX - highX) * cut;
        double y = highY + (lowY - highY) * cut;
        int name = name(source, highFromEnd, faceEnd, edge);
        addFacing(pose, x, y, height(x - endX, y - endY), reach, name, out);
    }

    /**
     * In overlap the nearest corner lies in front of the face; round-off put it beside, or the two
     * touch in a corner of either. Of an edge that lies flat both corners are as near: the one next
     * to the face is meant.
     */
    private void writeNearest(Pose pose, NormalSource source, Manifold out) {
        out.normal(normalX, normalY, source);
        out.turn(pose);
        boolean isLow = highFromStart > 0;
        double x = isLow ? lowX : highX;
        double y = isLow ? lowY : highY;
        int name = isLow ? name(source, 1, face, edgeEnd) : name(source, 1, faceEnd, edge);
        addPoint(
                pose,
                x - normalX * separation / 2,
                y - normalY * separation / 2,
                separation,
                name,
                out);
    }

    private void addFacing(
            Pose pose, double x, double y, double gap, double reach, int name, Manifold out) {
        if (gap <= reach) {
            addPoint(pose, x - normalX * gap / 2, y - normalY * gap / 2, gap, name, out);
        }
    }

    private static void addPoint(
            Pose pose, double x, double y, double gap, int name, Manifold out) {
        out.add(
                pose.x + (pose.cos * x - pose.sin * y),
                pose.y + (pose.sin * x + pose.cos * y),
                gap,
                name);
    }

    /**
     * Names a point after the corner that bounds it and the other polygon's edge. The name is the
     * same whichever polygon the reference is, because either sees the same corner inside.
     */
    private int name(NormalSource source, double inside, int ownCorner, int othersCorner) {
        boolean isReferenceA = source == NormalSource.FACE_A;
        boolean isSame = Math.abs(inside) < samePlace;
        boolean isOwn = isSame ? isReferenceA : inside < 0;
        int name = isOwn ? ownCorner | edge << 8 : othersCorner | face << 8;
        return isOwn == isReferenceA ? name : OF_B | name;
    }
}

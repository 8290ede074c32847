package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Outline;

/**
 * Clips the incident edge of one polygon to the extent of the other one's reference face. All
 * lengths are in the frame of the reference polygon. Values at one end of the face are measured
 * from that end, so that a mirrored scene gives mirrored bits.
 */
final class FaceClip {

    /**
     * Distance along the face, per metre of the narrower polygon, up to which two corners count as
     * one, whose point is named after A's corner: in a stack of equal boxes round-off decides which
     * of the two lies inside. Not a round number, so that no scene built on a grid sits on the
     * limit.
     */
    private static final double SAME_PLACE = 0.0137;

    /**
     * Distance beside the face, per metre of the narrower polygon, up to which a corner of a flat
     * incident edge counts as in front of it: a box that has sunk a little into the floor is still
     * in front of the whole wall. The error of the gap is less than half of this times the tilt.
     */
    private static final double BESIDE = 1e-5;

    /** Tilt up to which an edge counts as flat on a face, rad. */
    private static final double FLAT = 1e-4;

    /**
     * Cosine of the angle between a face's normal and the line between two corners. From this value
     * on, the other end of the overlap gets a point along that line too; at more than 26°, the line
     * says little about how that end lands.
     */
    private static final double NEARLY_ALONG = 0.9;

    private static final int OF_B = 1 << 16;
    private static final int OF_BOTH = 1 << 17;

    /** The reference face: its number and end corner, outward normal, start and end. */
    private int face;

    private int faceEnd;
    private double normalX;
    private double normalY;
    private double startX;
    private double startY;
    private double endX;
    private double endY;

    /** The incident edge. It runs opposite to the face, so its end lies near the face's start. */
    private int edge;

    private int edgeEnd;
    private double lowX;
    private double lowY;
    private double highX;
    private double highY;

    /**
     * Distance along the face of each end of the incident edge from the face's start, and from its
     * end; negative outside.
     */
    private double lowFromStart;

    private double highFromStart;
    private double lowFromEnd;
    private double highFromEnd;

    private double separation;
    private boolean isLowNearest;
    private double samePlace;

    /** Overlap of two cores without faces up to which they may lie in one line, m. */
    private double inLine;

    /** The larger number of corners of the two cores. */
    private int edgesInAll;

    private double beside;

    /**
     * Set if the closest features are two corners: one end of the face, and one end of the edge.
     */
    private boolean isBetweenCorners;

    private boolean isAtStart;
    private boolean isLowClosest;

    /**
     * Takes the face that a search found, and the edge that faces it most, of the other polygon at
     * a pose in the reference frame.
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
        inLine = PolygonPolygon.REFERENCE_BIAS * width;
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
            // At exactly 45° both edges face equally. Choosing the one whose far corner rises less
            // gives a mirrored scene the mirrored edge.
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
        // A core of two corners has no face across its own line. So two in one line are apart,
        // though no face separates them, or none by more than the bias for A's faces.
        boolean mayBeInLine = edgesInAll == 2 && separation > -inLine;
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

    /** Writes the manifold with the reference polygon at a pose. */
    void write(Pose pose, NormalSource source, double reach, Manifold out) {
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
    }

    /**
     * Writes the two nearest corners, and the far end of the overlap of edge and face. Cores with a
     * radius stay apart, so their corners can be nearest until the far end lands.
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

    /** Writes both ends of the overlap of edge and face, that at the start of A's face first. */
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
     * Writes the nearest corner in front of the face if the tests placed it beside the face: by
     * round-off, or because the two polygons touch corner to corner. Both corners of a flat edge
     * are equally near; it takes the one next to the face.
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
     * Feature id of a point: the corner that bounds it, and the other polygon's edge. It is the
     * same whichever polygon is the reference, because both see the same corner inside.
     */
    private int name(NormalSource source, double inside, int ownCorner, int othersCorner) {
        boolean isReferenceA = source == NormalSource.FACE_A;
        boolean isSame = Math.abs(inside) < samePlace;
        boolean isOwn = isSame ? isReferenceA : inside < 0;
        int name = isOwn ? ownCorner | edge << 8 : othersCorner | face << 8;
        return isOwn == isReferenceA ? name : OF_B | name;
    }
}

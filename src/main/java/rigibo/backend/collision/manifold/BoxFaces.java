package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Outline;

/**
 * The faces of greatest separation of two boxes. Symmetry leaves one comparison per axis instead of
 * one per face and corner: |p| minus both half extents, where p is the centre of one box in the
 * frame of the other. Twice as fast as the search over all faces.
 */
final class BoxFaces {

    /**
     * Corners of a box by the signs of x and y, in the order of {@link
     * rigibo.backend.geometry.Polygon#box}.
     */
    private static final int LOWER_LEFT = 0;

    private static final int LOWER_RIGHT = 1;
    private static final int UPPER_RIGHT = 2;
    private static final int UPPER_LEFT = 3;

    /** Faces by their outward normals. */
    private static final int BOTTOM = 0;

    private static final int RIGHT = 1;
    private static final int TOP = 2;
    private static final int LEFT = 3;

    private BoxFaces() {}

    /**
     * Finds the face of a box with the greatest separation from another box, whose pose is in the
     * first one's frame. Returns true, without a face, if a separation is more than {@code reach}
     * m.
     */
    static boolean isApart(Outline box, Outline other, Pose place, double reach, FaceSearch out) {
        double width = other.cornerX(UPPER_RIGHT);
        double height = other.cornerY(UPPER_RIGHT);
        double cos = place.cos;
        double sin = place.sin;
        double absCos = Math.abs(cos);
        double absSin = Math.abs(sin);
        double gapX =
                Math.abs(place.x) - box.cornerX(UPPER_RIGHT) - (absCos * width + absSin * height);
        double gapY =
                Math.abs(place.y) - box.cornerY(UPPER_RIGHT) - (absSin * width + absCos * height);
        if (gapX > reach || gapY > reach) {
            return true;
        }
        if (gapX > gapY) {
            boolean isRight = place.x > 0;
            out.separation = gapX;
            out.face = isRight ? RIGHT : LEFT;
            out.corner = isRight ? cornerTowards(-cos, sin) : cornerTowards(cos, -sin);
        } else {
            boolean isTop = place.y > 0;
            out.separation = gapY;
            out.face = isTop ? TOP : BOTTOM;
            out.corner = isTop ? cornerTowards(-sin, -cos) : cornerTowards(sin, cos);
        }
        return false;
    }

    /** The corner that is farthest along a direction in the box's own frame. */
    private static int cornerTowards(double x, double y) {
        if (y > 0) {
            return x > 0 ? UPPER_RIGHT : UPPER_LEFT;
        }
        return x > 0 ? LOWER_RIGHT : LOWER_LEFT;
    }
}

package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Outline;

/**
 * Manifold of two polygons. The face with the greatest separation is the reference face; the
 * incident edge, which is the edge of the other polygon that faces it most, is clipped to its
 * extent. Where the closest features are two corners, the normal is the line between them.
 */
final class PolygonPolygon {

    /**
     * Of two parallel faces, B's is the reference face only if its separation is greater than that
     * of A's by this much, per metre of the narrower polygon. Two stacked boxes of equal size tilt
     * by round-off; without the bias the reference face would keep changing between them.
     */
    static final double REFERENCE_BIAS = 1e-4;

    /**
     * Sine of the angle up to which two faces count as parallel for the bias. At corners the faces
     * differ by more, and the wrong one would turn the normal.
     */
    private static final double PARALLEL = 1e-2;

    /**
     * Overlap, per metre of the narrower polygon, up to which the other polygon's faces need no
     * search if its nearest corner lies well over a face. If the polygons are apart, this corner
     * and its foot on the face are the closest points, and no other face separates more. In an
     * overlap δ, a face at an angle θ to this one can separate more only if the foot is within
     * δ·tan(θ/2) of the face's end, since that end lies deep behind it; θ is at most a right angle
     * for the edges at the corner.
     */
    private static final double SHALLOW = 1e-2;

    /**
     * Distance of the foot from the ends of the face, per overlap, that counts as well over it:
     * enough for θ up to 150°.
     */
    private static final double WELL_OVER = 4;

    /** Distance of the centres, in widths, up to which two bodies count as at one spot. */
    private static final double ONE_SPOT = 1e-6;

    /** Cosine, in A's frame, of the direction along which bodies at one spot leave. */
    private static final double AT_ONE_SPOT = 0.8;

    /** Difference in widths up to which two ways out count as equally long. */
    private static final double EQUAL = 1e-3;

    private final double bias;
    private final FaceSearch facesA = new FaceSearch();
    private final FaceSearch facesB = new FaceSearch();

    /** Pose of B in the frame of A, and of A in the frame of B. */
    private final Pose placeB = new Pose();

    private final Pose placeA = new Pose();
    private final FaceClip clip = new FaceClip();

    /** {@code bias} is {@link #REFERENCE_BIAS}, or 0 to take the face of greatest separation. */
    PolygonPolygon(double bias) {
        this.bias = bias;
    }

    int collide(Outline a, Pose poseA, Outline b, Pose poseB, double reach, Manifold out) {
        double dx = poseB.x - poseA.x;
        double dy = poseB.y - poseA.y;
        double far = a.boundingRadius() + b.boundingRadius() + reach;
        if (!(dx * dx + dy * dy <= far * far)) {
            return 0;
        }
        double cos = poseA.cos * poseB.cos + poseA.sin * poseB.sin;
        double sin = poseA.cos * poseB.sin - poseA.sin * poseB.cos;
        // Each polygon's faces are tested in its own frame: a floor 10^6 m wide then keeps its
        // exact height, whatever the angle of the small box on it.
        placeB.set(poseA.cos * dx + poseA.sin * dy, poseA.cos * dy - poseA.sin * dx, cos, sin);
        placeA.set(-(poseB.cos * dx + poseB.sin * dy), poseB.sin * dx - poseB.cos * dy, cos, -sin);
        double radii = a.radius() + b.radius();
        double coreReach = reach + radii;
        if (areApart(a, b, coreReach)) {
            return 0;
        }
        double width = Math.min(a.smallestWidth(), b.smallestWidth());
        if (isReferenceA(a, b, width)) {
            clip.reference(a, facesA, b, placeB, width);
            clip.write(poseA, NormalSource.FACE_A, coreReach, out);
        } else {
            clip.reference(b, facesB, a, placeA, width);
            clip.write(poseB, NormalSource.FACE_B, coreReach, out);
        }
        if (radii > 0) {
            out.round(a.radius(), b.radius());
        }
        return out.count;
    }

    /**
     * Writes the manifold of two parts that overlap deeply, after {@link #collide} at the same
     * poses. The way out leads through a face that no other part of its body covers, so that a body
     * that leaves one part does not enter the next. Of ways of equal length it takes the one
     * nearest to the line between the bodies' centres; where these lie at one spot, nearest to a
     * direction that hardly any face has. So all parts of two bodies choose alike.
     */
    void leave(Outline a, Pose poseA, Outline b, Pose poseB, double reach, Manifold out) {
        double width = Math.min(a.smallestWidth(), b.smallestWidth());
        double apart = Math.sqrt(placeB.x * placeB.x + placeB.y * placeB.y);
        boolean isApart = apart > ONE_SPOT * width;
        double x = isApart ? placeB.x / apart : AT_ONE_SPOT;
        double y = isApart ? placeB.y / apart : Math.sqrt(1 - AT_ONE_SPOT * AT_ONE_SPOT);
        double backX = -(placeB.cos * x + placeB.sin * y);
        double backY = placeB.sin * x - placeB.cos * y;
        double bestA = facesA.findOuter(a, b, placeB, x, y, EQUAL * width);
        double bestB = facesB.findOuter(b, a, placeA, backX, backY, EQUAL * width);
        if (Math.max(bestA, bestB) == Double.NEGATIVE_INFINITY) {
            return;
        }
        out.clear();
        double coreReach = reach + a.radius() + b.radius();
        if (bestA >= bestB) {
            clip.reference(a, facesA, b, placeB, width);
            clip.write(poseA, NormalSource.FACE_A, coreReach, out);
        } else {
            clip.reference(b, facesB, a, placeA, width);
            clip.write(poseB, NormalSource.FACE_B, coreReach, out);
        }
        if (a.radius() + b.radius() > 0) {
            out.round(a.radius(), b.radius());
        }
    }

    private boolean areApart(Outline a, Outline b, double reach) {
        if (a.isBox() && b.isBox()) {
            return BoxFaces.isApart(a, b, placeB, reach, facesA)
                    || BoxFaces.isApart(b, a, placeA, reach, facesB);
        }
        return b.corners() < a.corners()
                ? isEitherApart(b, facesB, placeA, a, facesA, placeB, reach)
                : isEitherApart(a, facesA, placeB, b, facesB, placeA, reach);
    }

    /**
     * Searches the faces of the first polygon. It searches those of the other, which has more, only
     * if one of them may separate more.
     */
    private static boolean isEitherApart(
            Outline one,
            FaceSearch faces,
            Pose place,
            Outline other,
            FaceSearch otherFaces,
            Pose otherPlace,
            double reach) {
        if (faces.isApart(one, other, place, reach)) {
            return true;
        }
        double overlap = Math.max(0, -faces.separation);
        double shallow = SHALLOW * Math.min(one.smallestWidth(), other.smallestWidth());
        if (overlap <= shallow && faces.isOverFace(one, other, place, WELL_OVER * overlap)) {
            otherFaces.separation = Double.NEGATIVE_INFINITY;
            return false;
        }
        return otherFaces.isApart(other, one, otherPlace, reach);
    }

    private boolean isReferenceA(Outline a, Outline b, double width) {
        if (facesB.separation <= facesA.separation) {
            return true;
        }
        if (facesB.separation > facesA.separation + bias * width) {
            return false;
        }
        double ax = a.normalX(facesA.face);
        double ay = a.normalY(facesA.face);
        double nx = b.normalX(facesB.face);
        double ny = b.normalY(facesB.face);
        double bx = placeB.cos * nx - placeB.sin * ny;
        double by = placeB.sin * nx + placeB.cos * ny;
        return Math.abs(ax * by - ay * bx) < PARALLEL && ax * bx + ay * by < 0;
    }
}

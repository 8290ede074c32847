package rigibo.backend.collision.manifold;

/**
 * The feature from which a manifold takes its normal. The normal of a face is reliable across a
 * seam, that of a corner is not.
 */
public enum NormalSource {
    /** A face of A. */
    FACE_A,
    /** A face of B. */
    FACE_B,
    /** The line between the two closest points, at corners or on a disc. */
    CLOSEST_POINTS
}

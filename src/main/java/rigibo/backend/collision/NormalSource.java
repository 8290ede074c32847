package rigibo.backend.collision;

/** What gave a manifold its normal; a face's normal can be trusted over a seam, a corner's not. */
public enum NormalSource {
    /** A face of A. */
    FACE_A,
    /** A face of B. */
    FACE_B,
    /** The line between the two closest points: corners, or a disc's round outline. */
    CLOSEST_POINTS
}

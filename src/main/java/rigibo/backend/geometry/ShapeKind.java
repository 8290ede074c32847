package rigibo.backend.geometry;

/**
 * The kinds of shape. Switches over it have no default, so that the compiler finds a forgotten
 * kind.
 *
 * <pre>{@code
 * boolean isRound = crate.shape().kind() == ShapeKind.CIRCLE;
 * }</pre>
 */
public enum ShapeKind {
    /** {@link Circle}. */
    CIRCLE,

    /** {@link Capsule}. */
    CAPSULE,

    /** {@link Polygon}, sharp or rounded. */
    POLYGON,

    /** {@link Compound}. */
    COMPOUND,

    /** {@link Chain}. */
    CHAIN
}

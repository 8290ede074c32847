package rigibo.backend.geometry;

/**
 * The kinds of shape the engine knows; switches over it have no default, so none is forgotten.
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

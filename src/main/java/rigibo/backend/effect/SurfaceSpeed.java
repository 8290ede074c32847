package rigibo.backend.effect;

/**
 * Conveyors: the outline of a body runs at its material's surface speed, while the body stays as it
 * is. Counter-clockwise is positive, as for spin: what lies on top is carried to the left at a
 * positive speed and to the right at a negative one, and a body on tracks of its own moves as a
 * wheel of that rim speed would. Where two outlines meet, their speeds add. Friction carries, so it
 * has to be declared.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new SurfaceSpeed()));
 * pool.add(
 *         BodyDefinition.fixed(Polygon.box(6, 0.4)).material(wood.surfaceSpeed(-2))); // a belt
 * }</pre>
 */
public record SurfaceSpeed() implements Effect {}

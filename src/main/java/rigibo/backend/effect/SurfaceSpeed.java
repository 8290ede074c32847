package rigibo.backend.effect;

import java.util.List;

/**
 * Conveyor belts: the outline of a body runs at its material's surface speed, while the body itself
 * stays in place. Positive is counter-clockwise, as for spin: a load on top is carried to the left
 * by a positive speed and to the right by a negative one. A body with running tracks moves as a
 * wheel with that rim speed would. At a contact the speeds of both outlines add. {@link Friction}
 * must be declared, since it does the carrying.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new SurfaceSpeed()));
 * pool.add(
 *         BodyDefinition.fixed(Polygon.box(6, 0.4)).material(wood.surfaceSpeed(-2))); // a belt
 * }</pre>
 */
public record SurfaceSpeed() implements Effect {
    @Override
    public Kind kind() {
        return Kind.SURFACE_SPEED;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.FRICTION));
    }
}

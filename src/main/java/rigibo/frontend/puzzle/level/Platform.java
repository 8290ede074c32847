package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/**
 * The platform on which balls are to rest; it never moves.
 *
 * @param x of its centre, m
 * @param y of its centre, m, up
 * @param width m
 * @param height m
 * @param angle rad, counter-clockwise
 */
public record Platform(double x, double y, double width, double height, double angle) {

    /** The platform's name in the pool; no body of a level may have it. */
    public static final String NAME = "the platform";

    static final double USUAL_HEIGHT = 0.3;

    /** The engine's definition. */
    public BodyDefinition definition() {
        return BodyDefinition.fixed(Polygon.box(width, height))
                .at(x, y)
                .angle(angle)
                .material(Substance.PLANK.material())
                .name(NAME);
    }
}

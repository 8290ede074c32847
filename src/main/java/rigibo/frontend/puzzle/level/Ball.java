package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;

/**
 * The ball that has to get onto the platform.
 *
 * @param x of its centre, m
 * @param y of its centre, m, up
 * @param radius m
 * @param substance what it is made of
 * @param motion at the start
 */
public record Ball(double x, double y, double radius, Substance substance, Motion motion) {

    /** The ball's name in the pool; no body of a level may have it. */
    public static final String NAME = "the ball";

    /** What the engine is told. */
    public BodyDefinition definition() {
        return BodyDefinition.dynamic(new Circle(radius))
                .at(x, y)
                .velocity(motion.x(), motion.y())
                .spin(motion.spin())
                .material(substance.material())
                .name(NAME);
    }

    Ball shifted(double metres) {
        return new Ball(x + metres, y, radius, substance, motion);
    }
}

package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;

/**
 * A ball that must reach the platform.
 *
 * @param name in the pool and in messages; no body of a level may have it
 * @param x of its centre, m
 * @param y of its centre, m, up
 * @param radius m
 * @param substance of the ball
 * @param motion at the start
 */
public record Ball(
        String name, double x, double y, double radius, Substance substance, Motion motion) {

    /** Name of a level's first ball, usually the only one. */
    public static final String FIRST = "the ball";

    /** Names of further balls, from 2; an id has no blank. */
    static String named(int number) {
        return "ball " + number;
    }

    /** The engine's definition. */
    public BodyDefinition definition() {
        return BodyDefinition.dynamic(new Circle(radius))
                .at(x, y)
                .velocity(motion.x(), motion.y())
                .spin(motion.spin())
                .material(substance.material())
                .name(name);
    }

    Ball shifted(double metres) {
        return new Ball(name, x + metres, y, radius, substance, motion);
    }
}

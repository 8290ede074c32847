package rigibo.frontend.puzzle.level;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;

import java.util.OptionalDouble;

/**
 * The space of a level, with its origin at the bottom left, y up.
 *
 * @param width m
 * @param height m
 * @param effects the declared effects, gravity and water included
 */
public record World(double width, double height, Effects effects) {

    /** Density of a plate of water 1 m deep, kg/m², as the substances have them. */
    public static final double USUAL_WATER = 1000;

    /** Gravity on the Moon, m/s², and the largest difference that still counts as the Moon's. */
    private static final double MOON = -1.62;

    private static final double MOON_SPREAD = 0.3;

    /** Drag that calms a floating box within a second or two, 1/s. */
    public static final double USUAL_DRAG = 2;

    /** Gravity to the right, m/s²; 0 where it is not declared. */
    public double gravityX() {
        return effects.find(Gravity.class).map(Gravity::x).orElse(0.0);
    }

    /** Gravity upwards, m/s²; 0 where it is not declared. */
    public double gravityY() {
        return effects.find(Gravity.class).map(Gravity::y).orElse(0.0);
    }

    /** Whether gravity is about that of the Moon. */
    public boolean isOnTheMoon() {
        return isOnTheMoon(gravityX(), gravityY());
    }

    /** Whether a gravity to the right and upwards, m/s², is about that of the Moon. */
    public static boolean isOnTheMoon(double gravityX, double gravityY) {
        return Math.abs(gravityX) < MOON_SPREAD && Math.abs(gravityY - MOON) < MOON_SPREAD;
    }

    /** Height of the water's surface, m above the world's bottom; empty if there is no water. */
    public OptionalDouble waterLevel() {
        return effects.find(Buoyancy.class).stream().mapToDouble(Buoyancy::level).findFirst();
    }
}

package rigibo.backend.effect;

import rigibo.backend.setup.Require;

/**
 * A uniform acceleration of every dynamic body, multiplied by the body's gravity scale.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new Gravity(0, -1.62))); // the moon
 * }</pre>
 *
 * @param x m/s², to the right, within ±1e6
 * @param y m/s², up, within ±1e6; on Earth -9.81
 */
public record Gravity(double x, double y) implements Effect {

    /** Strongest acceleration accepted, m/s². */
    public static final double MOST = 1e6;

    /**
     * Checks both components.
     *
     * @throws IllegalArgumentException when one is not within ±1e6 m/s²
     */
    public Gravity {
        Require.within("Gravity.x", x, -MOST, MOST, "m/s²");
        Require.within("Gravity.y", y, -MOST, MOST, "m/s²");
    }

    @Override
    public Kind kind() {
        return Kind.GRAVITY;
    }

    @Override
    public double[] numbers() {
        return new double[] {x, y};
    }
}

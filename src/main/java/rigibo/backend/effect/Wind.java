package rigibo.backend.effect;

import rigibo.backend.setup.Require;

import java.util.List;

/**
 * Moving air: {@link Drag} and {@link AirDrag} act on the velocity relative to it. One of the two
 * must be declared.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new AirDrag(1.2, 1.1)).with(new Wind(10, 0)));
 * }</pre>
 *
 * @param x speed of the air to the right, m/s, within ±1e4
 * @param y speed of the air upwards, m/s, within ±1e4
 * @param gusts factor on that speed over time; {@link Gusts#STEADY} for a constant wind
 */
public record Wind(double x, double y, Gusts gusts) implements Effect {

    /** Strongest wind accepted, m/s. */
    public static final double MOST = 1e4;

    /**
     * Checks every part.
     *
     * @throws IllegalArgumentException when a speed is not within ±1e4 m/s or there are no gusts
     */
    public Wind {
        Require.within("Wind.x", x, -MOST, MOST, "m/s");
        Require.within("Wind.y", y, -MOST, MOST, "m/s");
        Require.present("Wind.gusts", gusts);
    }

    /**
     * A constant wind.
     *
     * @param x m/s, to the right
     * @param y m/s, up
     * @throws IllegalArgumentException when a speed is not within ±1e4 m/s
     */
    public Wind(double x, double y) {
        this(x, y, Gusts.STEADY);
    }

    /** Whether the wind is constant. */
    public boolean isSteady() {
        return gusts == Gusts.STEADY;
    }

    @Override
    public boolean holdsFunction() {
        return !isSteady();
    }

    @Override
    public Kind kind() {
        return Kind.WIND;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.DRAG, Kind.AIR_DRAG));
    }

    @Override
    public double[] numbers() {
        return new double[] {x, y};
    }
}

package rigibo.backend.effect;

/**
 * A function that scales a {@link Wind} over time. It is called within a step.
 *
 * <pre>{@code
 * Gusts sway = time -> 1 + 0.5 * Angle.sin(time); // of rigibo.backend.geometry, the same bits everywhere
 * }</pre>
 */
@FunctionalInterface
public interface Gusts {

    /** A constant wind, at its stated speed. */
    Gusts STEADY = time -> 1;

    /**
     * The factor on the stated wind: 1 for its full speed, 0 for calm, negative for the opposite
     * direction. Equal times must give equal factors.
     *
     * @param time simulated time since the pool was made, s
     */
    double at(double time);
}

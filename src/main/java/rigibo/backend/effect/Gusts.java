package rigibo.backend.effect;

/**
 * How a wind changes with time. Called within a step, and given a number only.
 *
 * <pre>{@code
 * Gusts sway = time -> 1 + 0.5 * Math.sin(time);
 * }</pre>
 */
@FunctionalInterface
public interface Gusts {

    /** The wind as it is stated, at all times. */
    Gusts STEADY = time -> 1;

    /**
     * The share of the stated wind that blows: 1 for all of it, 0 for calm, negative for the
     * opposite direction. The same time must always give the same share.
     *
     * @param time s since the pool was made
     */
    double at(double time);
}

package rigibo.backend.effect;

import rigibo.backend.setup.Require;

import java.util.List;

/**
 * Islands of bodies at rest fall asleep: they are no longer simulated until something wakes them.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new Sleep(1, 0.001))); // 1 s within 1 mm
 * }</pre>
 *
 * @param seconds time for which every body of an island must stay in place, s, positive
 * @param distance how far a body one metre wide may move in that time, m, positive; scales with the
 *     width of the body
 */
public record Sleep(double seconds, double distance) implements Effect {

    /**
     * Checks both thresholds.
     *
     * @throws IllegalArgumentException when one is not positive and finite
     */
    public Sleep {
        Require.positive("Sleep.seconds", seconds, "s");
        Require.positive("Sleep.distance", distance, "m");
    }

    /**
     * The default: 0.5 s within 0.1 mm. That is 0.2 mm/s, far slower than the eye can see and far
     * faster than the residual motion of a stack at rest.
     */
    public Sleep() {
        this(0.5, 1e-4);
    }

    @Override
    public Kind kind() {
        return Kind.SLEEP;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.CONTACTS));
    }

    @Override
    public double[] numbers() {
        return new double[] {seconds, distance};
    }
}

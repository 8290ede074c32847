package rigibo.backend.effect;

import rigibo.backend.setup.Require;

/**
 * Islands of bodies that rest stop costing until something touches them.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new Sleep(1, 0.001))); // 1 s within 1 mm
 * }</pre>
 *
 * @param seconds how long every body of an island must have stayed in place, s, positive
 * @param distance how far a body of one metre may stray meanwhile, m, positive; scales with size
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
     * Half a second within a tenth of a millimetre: 0.2 mm/s, far below what an eye sees move, far
     * above the residue of a resting stack.
     */
    public Sleep() {
        this(0.5, 1e-4);
    }
}

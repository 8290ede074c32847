package rigibo.frontend.scene.accuracy;

/**
 * Balances a scene's energy since it began or was last edited: E = E₀ − lost + drift + work, exact
 * up to the rounding of this sum. An edit shows as an energy before a step that differs from that
 * after the last one; then a new balance begins.
 *
 * <p>The declared effects decide how a change is classified, see {@link EnergyKind}. Where energy
 * is lost by design, a loss cannot be distinguished from downward drift and counts as lost. Such
 * energy cannot rise again without work, so any rise above its lowest value is drift.
 */
public final class EnergyBook {

    /** Steps that the curve shows: 10 s. */
    public static final int WINDOW = 600;

    private final double[] sinceFirst = new double[WINDOW];
    private final double[] sinceLowest = new double[WINDOW];
    private double first;
    private double lowest;
    private double now = Double.NaN;
    private int steps;

    /** Takes the energy before a step, J. */
    public void before(double joules) {
        // The same sum over the same state has the same bits, so no tolerance is needed.
        if (joules != now) {
            first = joules;
            lowest = joules;
            now = joules;
            steps = 0;
        }
    }

    /** Takes the energy after the step, J. */
    public void after(double joules) {
        now = joules;
        lowest = Math.min(lowest, joules);
        sinceFirst[steps % WINDOW] = now - first;
        sinceLowest[steps % WINDOW] = now - lowest;
        steps++;
    }

    /** Steps since the account began. */
    public int steps() {
        return steps;
    }

    /** E₀, when the account began, J. */
    public double first() {
        return first;
    }

    /** J, 0 or more: lost by design, and drift downwards with it. */
    public double lost(EnergyKind kind) {
        return kind == EnergyKind.LOSING ? first - lowest : 0;
    }

    /** Change of energy that no declared effect explains, J. */
    public double drift(EnergyKind kind) {
        return switch (kind) {
            case CONSERVED -> now - first;
            case LOSING -> now - lowest;
            case WORKED -> 0;
        };
    }

    /**
     * Change of energy where work is done, J. Losses are included, since they cannot be told apart.
     */
    public double work(EnergyKind kind) {
        return kind == EnergyKind.WORKED ? now - first : 0;
    }

    /**
     * The drift after each of the last steps, or the work where some is done, J, from the oldest.
     *
     * @param into {@link #WINDOW} long
     * @return how many there are
     */
    public int curve(EnergyKind kind, double[] into) {
        double[] from = kind == EnergyKind.LOSING ? sinceLowest : sinceFirst;
        int count = Math.min(steps, WINDOW);
        for (int i = 0; i < count; i++) {
            into[i] = from[(steps - count + i) % WINDOW];
        }
        return count;
    }
}

package rigibo.backend.contact;

import rigibo.backend.setup.SolveMethod;

/** Solves all rows of a packed island at once, each within its bounds. */
interface WholeSolver {

    /** As the step's report calls it. */
    SolveMethod method();

    /** The rows are not what they were: a factor of them is worth nothing. */
    void forget();

    /** Begins a substep: what was spent counts anew. */
    void begin();

    /** Whether what is left of the rows is not worth more in this substep. */
    boolean isSpent();

    /**
     * Brings the rows to rest against each other, for a substep of h seconds, but for a speed of
     * {@code settled} m/s. Nothing went faster than {@code fastest} m/s before.
     */
    void solve(double h, int substep, double settled, double fastest);

    /** The least share of the fastest speed that is worth asking for. */
    double finestShare();

    /** Takes overlap back by moving bodies, after a substep that began as fast. */
    void correct(double h, int substep, double fastest);
}

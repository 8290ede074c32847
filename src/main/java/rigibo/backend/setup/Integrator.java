package rigibo.backend.setup;

/**
 * How bodies in flight are integrated. {@link #BALLISTIC} is exact for constant accelerations and
 * linear drag at any length of step. Forces that vary along the path ({@code Field}, {@code
 * CentralForce}, {@code AirDrag}, gusts, {@code Buoyancy}) are integrated numerically in {@link
 * Accuracy#substeps} substeps.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.FINE.withIntegrator(Integrator.RK4));
 * }</pre>
 */
public enum Integrator {
    /** Symplectic Euler, first order. */
    EULER,
    /** Velocity Verlet, second order. */
    VERLET,
    /** Runge and Kutta, fourth order. */
    RK4,
    /**
     * Exact under constant acceleration and linear drag; the contribution of other forces is
     * integrated by fourth-order Runge–Kutta.
     */
    BALLISTIC
}

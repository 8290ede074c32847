package rigibo.backend.setup;

/**
 * How a body in flight is moved. What is the same all along a step is exact with {@link #BALLISTIC}
 * at any step; forces that change along the way ({@code Field}, {@code CentralForce}, {@code
 * AirDrag}, gusts, {@code Buoyancy}) are integrated in {@link Accuracy#substeps} steps.
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
     * Exact under constant acceleration and linear drag; of fourth order, after Runge and Kutta, in
     * what other forces add.
     */
    BALLISTIC
}

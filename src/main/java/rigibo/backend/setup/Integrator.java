package rigibo.backend.setup;

/** How a body in flight is moved. */
public enum Integrator {
    /** Symplectic Euler, first order. */
    EULER,
    /** Velocity Verlet, second order. */
    VERLET,
    /** Runge and Kutta, fourth order. */
    RK4,
    /** Exact under constant acceleration and linear drag, at any step. */
    BALLISTIC
}

package rigibo.peers.rust;

/**
 * The functions of the library, by numbers only: SI units, places and velocities of centres of
 * mass. A world is identified by its address, a body by its number. The library checks nothing;
 * {@link RustWorld} passes only valid arguments.
 */
final class Calls {

    static {
        Library.load();
    }

    private Calls() {}

    /** The version: major · 10,000 + minor · 100 + patch. */
    static native int version(int engine);

    static native long create(
            int engine,
            double gravityX,
            double gravityY,
            boolean hasSleep,
            boolean hasContinuousImpacts,
            int substeps,
            int workers);

    static native void destroy(long world);

    /** Adds a corner to the next shape. */
    static native void corner(long world, double x, double y);

    /** Adds a convex shape, of the corners so far, rounded, to the next body. */
    static native void outline(long world, double radius);

    /** Adds a chain of the corners so far to the next body. */
    static native void chain(long world, boolean isLoop);

    static native void add(
            long world,
            int kind,
            double x,
            double y,
            double angle,
            double velocityX,
            double velocityY,
            double spin,
            double mass,
            double inertia,
            double friction,
            double elasticity,
            double damping,
            double gravityScale,
            int group,
            boolean mayTurn,
            boolean isAwake);

    static native void join(
            long world,
            int kind,
            int a,
            int b,
            double x,
            double y,
            double toX,
            double toY,
            boolean hasLimits,
            double lower,
            double upper,
            boolean hasMotor,
            double speed,
            double most,
            boolean hasSpring,
            double hertz,
            double dampingRatio);

    static native void remove(long world, int body);

    static native void step(long world, double seconds);

    static native void push(long world, int body, double forceX, double forceY);

    static native void drive(long world, int body, double velocityX, double velocityY, double spin);

    static native double x(long world, int body);

    static native double y(long world, int body);

    static native double angle(long world, int body);

    static native double velocityX(long world, int body);

    static native double velocityY(long world, int body);

    static native double spin(long world, int body);

    static native double normalImpulse(long world, int a, int b);

    static native double ray(long world, double fromX, double fromY, double toX, double toY);
}

package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Exponential;
import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;

/**
 * Motion of a body within a step: constant acceleration and linear drag, exactly. Mutable, so that
 * stages can reuse one object; times are in s after the step's start.
 *
 * <p>With drag k: v' = a − k·v, so x = x₀ + v·E₁ + a·E₂ with E₁ = (1 − e^(−kτ))/k and E₂ = (τ −
 * E₁)/k, which become τ and τ²/2 without drag. The angle is θ + ωτ + ½ατ².
 */
public final class Motion {

    /**
     * Product kτ below which E₂ is summed as a series, because the closed form loses digits there.
     */
    private static final double SMALL_DECAY = 1.0 / 16;

    /**
     * Coefficients of that series, without sign; its tenth term, (1/16)⁹/11!, is below round-off.
     */
    private static final double[] SERIES = inverseFactorials(9);

    public Outline outline;

    /** Time of the state below, s. */
    public double startTime;

    /** Position of the centre of mass, m, and angle, rad. */
    public double x;

    public double y;
    public double angle;

    /** Velocity in m/s and angular velocity in rad/s. */
    public double velocityX;

    public double velocityY;
    public double spin;

    /** Acceleration in m/s² and angular acceleration in rad/s². */
    public double accelerationX;

    public double accelerationY;
    public double angularAcceleration;

    /** Linear drag, 1/s, zero or more. */
    public double drag;

    /** The angle whose cosine and sine were computed last; kept because many bodies do not turn. */
    private double knownAngle;

    private double knownCos = 1;
    private double knownSin;

    /**
     * Takes the state of a body in flight at the step's start, without drag and without turning.
     */
    public void take(Bodies bodies, int slot) {
        outline = bodies.outline[slot];
        startTime = 0;
        x = bodies.x[slot];
        y = bodies.y[slot];
        angle = bodies.angle[slot];
        velocityX = bodies.velocityX[slot];
        velocityY = bodies.velocityY[slot];
        spin = 0;
        accelerationX = bodies.accelerationX[slot];
        accelerationY = bodies.accelerationY[slot];
        angularAcceleration = 0;
        drag = 0;
    }

    /** Takes outline and pose of a body, as if it stood still. */
    public void takePose(Bodies bodies, int slot) {
        outline = bodies.outline[slot];
        startTime = 0;
        x = bodies.x[slot];
        y = bodies.y[slot];
        angle = bodies.angle[slot];
        velocityX = 0;
        velocityY = 0;
        spin = 0;
        accelerationX = 0;
        accelerationY = 0;
        angularAcceleration = 0;
        drag = 0;
    }

    /** Takes the angular velocity and acceleration of a body; needs rotation. */
    public void takeTurning(Bodies bodies, int slot) {
        spin = bodies.spin[slot];
        angularAcceleration = bodies.angularAcceleration[slot];
    }

    /** Writes the pose at a time in s. */
    public void poseAt(double time, Pose out) {
        placeAt(time, out);
        double turned = angleAt(time);
        if (Double.doubleToRawLongBits(turned) != Double.doubleToRawLongBits(knownAngle)) {
            // Compared by bits: the sine of −0.0 is −0.0, and results must not depend on earlier
            // calls.
            knownAngle = turned;
            knownCos = Angle.cos(turned);
            knownSin = Angle.sin(turned);
        }
        out.cos = knownCos;
        out.sin = knownSin;
    }

    /** Writes the centre of mass at a time in s, and leaves the orientation as it is. */
    public void placeAt(double time, Pose out) {
        double elapsed = time - startTime;
        double e1 = velocityShare(elapsed);
        double e2 = accelerationShare(elapsed, e1);
        out.x = x + (velocityX * e1 + accelerationX * e2);
        out.y = y + (velocityY * e1 + accelerationY * e2);
    }

    /**
     * Advances position and velocity of the centre of mass to a time in s, with one exponential
     * instead of three.
     */
    public void advance(double time) {
        double elapsed = time - startTime;
        double e1 = velocityShare(elapsed);
        double e2 = accelerationShare(elapsed, e1);
        x += velocityX * e1 + accelerationX * e2;
        y += velocityY * e1 + accelerationY * e2;
        double ax = accelerationXNow();
        double ay = accelerationYNow();
        velocityX += ax * e1;
        velocityY += ay * e1;
        startTime = time;
    }

    /** Angle at a time in s, rad, counter-clockwise. */
    public double angleAt(double time) {
        double elapsed = time - startTime;
        return angle + elapsed * (spin + elapsed * angularAcceleration / 2);
    }

    /** Velocity along x at a time in s, m/s. */
    public double velocityXAt(double time) {
        return velocityX + accelerationXNow() * velocityShare(time - startTime);
    }

    /** Velocity along y at a time in s, m/s. */
    public double velocityYAt(double time) {
        return velocityY + accelerationYNow() * velocityShare(time - startTime);
    }

    /** Angular velocity at a time in s, rad/s. */
    public double spinAt(double time) {
        return spin + (time - startTime) * angularAcceleration;
    }

    /** dv/dt at the start of the motion, including drag, m/s². */
    private double accelerationXNow() {
        return accelerationX - drag * velocityX;
    }

    private double accelerationYNow() {
        return accelerationY - drag * velocityY;
    }

    /**
     * Smallest dv/dt along a direction from a time on, including drag, m/s². Without drag it is
     * constant; with drag it decays to 0 from either side.
     */
    double leastAcceleration(double directionX, double directionY, double time) {
        double now = directionX * accelerationXNow() + directionY * accelerationYNow();
        return drag > 0 ? Math.min(0, now * (1 - drag * velocityShare(time - startTime))) : now;
    }

    /** Whether the angle changes. */
    boolean isTurning() {
        return spin != 0 || angularAcceleration != 0;
    }

    /** Largest angular speed between two times, rad/s. */
    double mostSpin(double from, double to) {
        return Math.max(Math.abs(spinAt(from)), Math.abs(spinAt(to)));
    }

    /** Upper bound on the acceleration that turning gives any point of the outline, m/s². */
    double turningAcceleration(double from, double to) {
        double fastest = mostSpin(from, to);
        return (fastest * fastest + Math.abs(angularAcceleration)) * outline.boundingRadius();
    }

    /** Speed of this body's centre relative to another's at a time, m/s. */
    double speedAgainst(Motion other, double time) {
        double vx = velocityXAt(time) - other.velocityXAt(time);
        double vy = velocityYAt(time) - other.velocityYAt(time);
        return Math.sqrt(vx * vx + vy * vy);
    }

    /**
     * Upper bound on the acceleration of this body's centre relative to another's from a time on,
     * m/s². Without drag both are constant; with drag each decays at its own rate.
     */
    double accelerationAgainst(Motion other, double time) {
        if (drag == 0 && other.drag == 0) {
            double ax = accelerationX - other.accelerationX;
            double ay = accelerationY - other.accelerationY;
            return Math.sqrt(ax * ax + ay * ay);
        }
        return accelerationSize(time) + other.accelerationSize(time);
    }

    private double accelerationSize(double time) {
        double ax = accelerationXNow();
        double ay = accelerationYNow();
        return Math.sqrt(ax * ax + ay * ay) * (1 - drag * velocityShare(time - startTime));
    }

    /** Displacement of the centre along a direction since the start of the motion, m. */
    double movedAlong(double directionX, double directionY, double time) {
        double elapsed = time - startTime;
        double e1 = velocityShare(elapsed);
        double e2 = accelerationShare(elapsed, e1);
        return directionX * (velocityX * e1 + accelerationX * e2)
                + directionY * (velocityY * e1 + accelerationY * e2);
    }

    /** E₁ in s: displacement per unit of velocity. */
    public double velocityShare(double elapsed) {
        return drag > 0 ? -Exponential.expm1(-drag * elapsed) / drag : elapsed;
    }

    /** E₂ in s²: displacement per unit of acceleration. */
    public double accelerationShare(double elapsed, double e1) {
        double decay = drag * elapsed;
        if (decay == 0) {
            return elapsed * elapsed / 2;
        }
        return Math.abs(decay) < SMALL_DECAY
                ? elapsed * elapsed * series(decay)
                : (elapsed - e1) / drag;
    }

    /** The series 1/2! − z/3! + z²/4! − … of (z − 1 + e^(−z))/z². */
    private static double series(double z) {
        double sum = 0;
        for (int i = SERIES.length - 1; i >= 0; i--) {
            sum = SERIES[i] - sum * z;
        }
        return sum;
    }

    /** 1/2!, 1/3! and so on. */
    private static double[] inverseFactorials(int count) {
        double[] inverse = new double[count];
        double factorial = 1;
        for (int i = 0; i < count; i++) {
            factorial *= i + 2;
            inverse[i] = 1 / factorial;
        }
        return inverse;
    }
}

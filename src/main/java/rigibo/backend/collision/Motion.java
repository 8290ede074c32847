package rigibo.backend.collision;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;

/**
 * How a body moves within a step: constant acceleration and linear drag, exactly. A plain carrier
 * that stages reuse; times are in s after the step's start.
 *
 * <p>With drag k: v' = a − k·v, so x = x₀ + v·E₁ + a·E₂ with E₁ = (1 − e^(−kτ))/k and E₂ = (τ −
 * E₁)/k, which become τ and τ²/2 without drag.
 */
public final class Motion {

    public Shape shape;

    /** When the columns below hold, s. */
    public double startTime;

    /** m and rad. */
    public double x;

    public double y;
    public double angle;

    /** m/s and rad/s. */
    public double velocityX;

    public double velocityY;
    public double spin;

    /** m/s² and rad/s². */
    public double accelerationX;

    public double accelerationY;
    public double angularAcceleration;

    /** 1/s. */
    public double drag;

    /** Writes where the body is at a time in s. */
    public void poseAt(double time, Pose out) {
        double elapsed = time - startTime;
        double e1 = gained(elapsed);
        double e2 = drag > 0 ? (elapsed - e1) / drag : elapsed * elapsed / 2;
        double turned = angleAt(time);
        out.set(
                x + velocityX * e1 + accelerationX * e2,
                y + velocityY * e1 + accelerationY * e2,
                Angle.cos(turned),
                Angle.sin(turned));
    }

    /** rad, counter-clockwise. */
    public double angleAt(double time) {
        double elapsed = time - startTime;
        return angle + elapsed * (spin + elapsed * angularAcceleration / 2);
    }

    /** Velocity to the right at a time in s, m/s. */
    public double velocityXAt(double time) {
        double e1 = gained(time - startTime);
        return velocityX + (accelerationX - drag * velocityX) * e1;
    }

    /** Velocity upwards at a time in s, m/s. */
    public double velocityYAt(double time) {
        double e1 = gained(time - startTime);
        return velocityY + (accelerationY - drag * velocityY) * e1;
    }

    /** rad/s at a time in s. */
    public double spinAt(double time) {
        return spin + (time - startTime) * angularAcceleration;
    }

    /** A bound on how fast any point of the outline changes its velocity up to a time, m/s². */
    double curvature(double end) {
        double speed = Math.abs(velocityX) + Math.abs(velocityY);
        double acceleration = Math.abs(accelerationX) + Math.abs(accelerationY) + drag * speed;
        if (shape.kind() == ShapeKind.CIRCLE) {
            return acceleration;
        }
        double fastest =
                Math.abs(spin) + Math.abs(angularAcceleration) * Math.max(0, end - startTime);
        double turning = fastest * fastest + Math.abs(angularAcceleration);
        return acceleration + turning * shape.boundingRadius();
    }

    private double gained(double elapsed) {
        return drag > 0 ? -StrictMath.expm1(-drag * elapsed) / drag : elapsed;
    }
}

package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Manifold;
import rigibo.backend.collision.manifold.Pose;

/** The approach of two moving bodies: tests that exclude an impact, and tests that confirm one. */
final class Approach {

    /** Closing speed, as a share of the bodies' speeds, below which it is round-off of the axis. */
    private static final double SPEED_ROUNDING = 1e-13;

    private Motion a;
    private Motion b;

    /** Sets the two motions. */
    void between(Motion first, Motion second) {
        a = first;
        b = second;
    }

    /**
     * Whether the bounding circles can come within a gap in m between two times; uses the line
     * between their centres.
     */
    boolean mayMeet(Pose poseA, Pose poseB, double from, double to, double within) {
        double dx = poseB.x - poseA.x;
        double dy = poseB.y - poseA.y;
        double apart = Math.sqrt(dx * dx + dy * dy);
        double gap = apart - a.outline.boundingRadius() - b.outline.boundingRadius();
        if (!(gap > within)) {
            return true;
        }
        double nx = dx / apart;
        double ny = dy / apart;
        double left = to - from;
        double gained = left * Math.min(0, pull(nx, ny, from)) / 2;
        return gap + left * (centreSpeed(nx, ny, from) + gained) <= within;
    }

    /** Whether the gap shrinks or is about to, because forces press resting bodies together. */
    boolean isClosing(Distance distance, Pose poseA, Pose poseB, double time, double tolerance) {
        double speed = partingSpeed(distance, poseA, poseB, time, tolerance);
        double noise = SPEED_ROUNDING * (speedOf(a) + speedOf(b));
        double pulls = SPEED_ROUNDING * (pullOf(a) + pullOf(b));
        boolean isPressed = pull(distance.axisX, distance.axisY, time) < -pulls;
        return speed < -noise || speed <= noise && isPressed;
    }

    /**
     * Relative speed of the closest points along the normal, m/s, positive when parting. Of two
     * contact points the one with the smaller speed counts, unless its gap is larger by more than a
     * tolerance in m.
     */
    double partingSpeed(Distance distance, Pose poseA, Pose poseB, double time, double tolerance) {
        Manifold points = distance.manifold;
        double nx = points.normalX;
        double ny = points.normalY;
        double spinA = a.spinAt(time);
        double spinB = b.spinAt(time);
        double slowest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < points.count; i++) {
            if (points.separation[i] <= distance.gap + tolerance) {
                double px = points.pointX[i];
                double py = points.pointY[i];
                double leverA = (px - poseA.x) * ny - (py - poseA.y) * nx;
                double leverB = (px - poseB.x) * ny - (py - poseB.y) * nx;
                slowest = Math.min(slowest, spinB * leverB - spinA * leverA);
            }
        }
        return slowest + centreSpeed(nx, ny, time);
    }

    private double centreSpeed(double nx, double ny, double time) {
        return nx * (b.velocityXAt(time) - a.velocityXAt(time))
                + ny * (b.velocityYAt(time) - a.velocityYAt(time));
    }

    /** Smallest acceleration of B away from A along an axis, m/s². */
    private double pull(double nx, double ny, double time) {
        return b.leastAcceleration(nx, ny, time) + a.leastAcceleration(-nx, -ny, time);
    }

    private static double pullOf(Motion body) {
        return Math.abs(body.accelerationX) + Math.abs(body.accelerationY);
    }

    private static double speedOf(Motion body) {
        return Math.abs(body.velocityX)
                + Math.abs(body.velocityY)
                + Math.abs(body.spin) * body.outline.boundingRadius();
    }
}

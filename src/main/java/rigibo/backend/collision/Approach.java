package rigibo.backend.collision;

/** How two moving bodies near each other: what rules a meeting out, and what makes it a hit. */
final class Approach {

    /** Closing slower than this share of the bodies' speed is round-off of the axis. */
    private static final double SPEED_ROUNDING = 1e-13;

    private Motion a;
    private Motion b;

    /** Takes the two motions. */
    void between(Motion first, Motion second) {
        a = first;
        b = second;
    }

    /**
     * Whether the bounding circles can come within a gap in m between two times, seen along the
     * line between their centres.
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

    /** Whether the gap shrinks, or is about to: bodies at rest are pressed together by forces. */
    boolean isClosing(Distance distance, Pose poseA, Pose poseB, double time, double tolerance) {
        double speed = partingSpeed(distance, poseA, poseB, time, tolerance);
        double noise = SPEED_ROUNDING * (speedOf(a) + speedOf(b));
        double pulls = SPEED_ROUNDING * (pullOf(a) + pullOf(b));
        boolean isPressed = pull(distance.axisX, distance.axisY, time) < -pulls;
        return speed < -noise || speed <= noise && isPressed;
    }

    /**
     * Speed in m/s at which the closest points part. Where an edge is closest, the slower of its
     * ends counts, unless it is farther by more than a tolerance in m.
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

    /** The least acceleration in m/s² of B away from A along an axis. */
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

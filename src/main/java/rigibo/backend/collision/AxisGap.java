package rigibo.backend.collision;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;

/**
 * The gap of two moving shapes along a fixed axis: never more than their distance, and smooth but
 * for changes of corner.
 */
final class AxisGap {

    private final Pose pose = new Pose();
    private Motion a;
    private Motion b;
    private double axisX;
    private double axisY;

    /** How often a gap was measured. */
    int evaluations;

    /** Fixes the axis, a unit vector from A to B. */
    void fix(Motion first, Motion second, double x, double y) {
        a = first;
        b = second;
        axisX = x;
        axisY = y;
    }

    /** The gap at a time in s, m. */
    double at(double time) {
        evaluations++;
        a.poseAt(time, pose);
        double ax = pose.x;
        double ay = pose.y;
        double reachA = support(a.shape, pose, axisX, axisY);
        b.poseAt(time, pose);
        double reachB = support(b.shape, pose, -axisX, -axisY);
        return axisX * (pose.x - ax) + axisY * (pose.y - ay) - reachA - reachB;
    }

    /** Speed in m/s at which the gap changes at a time; negative when it closes. */
    double speedAt(double time, double tolerance) {
        double along =
                axisX * (b.velocityXAt(time) - a.velocityXAt(time))
                        + axisY * (b.velocityYAt(time) - a.velocityYAt(time));
        a.poseAt(time, pose);
        double outA = fastestOutward(a.shape, pose, a.spinAt(time), axisX, axisY, tolerance);
        b.poseAt(time, pose);
        double outB = fastestOutward(b.shape, pose, b.spinAt(time), -axisX, -axisY, tolerance);
        return along - outA - outB;
    }

    /** How far a shape reaches along a world direction from its centre, m. */
    private static double support(Shape shape, Pose pose, double dx, double dy) {
        if (shape.kind() == ShapeKind.CIRCLE) {
            return shape.boundingRadius();
        }
        Polygon polygon = (Polygon) shape;
        double lx = pose.cos * dx + pose.sin * dy;
        double ly = pose.cos * dy - pose.sin * dx;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < polygon.corners(); i++) {
            most = Math.max(most, lx * polygon.cornerX(i) + ly * polygon.cornerY(i));
        }
        return most;
    }

    /** How fast turning moves the outermost corners along a direction, m/s. */
    private static double fastestOutward(
            Shape shape, Pose pose, double spin, double dx, double dy, double tolerance) {
        if (shape.kind() == ShapeKind.CIRCLE || spin == 0) {
            return 0;
        }
        Polygon polygon = (Polygon) shape;
        double lx = pose.cos * dx + pose.sin * dy;
        double ly = pose.cos * dy - pose.sin * dx;
        double outermost = support(shape, pose, dx, dy) - tolerance;
        double fastest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < polygon.corners(); i++) {
            double x = polygon.cornerX(i);
            double y = polygon.cornerY(i);
            if (lx * x + ly * y >= outermost) {
                fastest = Math.max(fastest, spin * (ly * x - lx * y));
            }
        }
        return fastest;
    }
}

package rigibo.fuzz.judge;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Length;
import rigibo.backend.geometry.Polygon;

/**
 * The outline of a body in the world, computed from its shape and pose by simple formulas. The
 * answers that the engine finds by trees and searches are compared with it.
 */
final class Outline {

    /** The tolerance between the two, as a share of the lengths involved. */
    private static final double ROUND_OFF = 1e-7;

    private final double x;
    private final double y;
    private final double radius;

    /** The corners and outward normals; a disc has none. */
    private final double[] cornerX;

    private final double[] cornerY;
    private final double[] normalX;
    private final double[] normalY;

    Outline(RigidBody body) {
        x = body.x();
        y = body.y();
        radius = body.shape().boundingRadius();
        int corners = body.shape() instanceof Polygon polygon ? polygon.corners() : 0;
        cornerX = new double[corners];
        cornerY = new double[corners];
        normalX = new double[corners];
        normalY = new double[corners];
        if (body.shape() instanceof Polygon polygon) {
            place(polygon, Angle.cos(body.angle()), Angle.sin(body.angle()));
        }
    }

    private void place(Polygon p, double cos, double sin) {
        for (int i = 0; i < cornerX.length; i++) {
            cornerX[i] = x + cos * p.cornerX(i) - sin * p.cornerY(i);
            cornerY[i] = y + sin * p.cornerX(i) + cos * p.cornerY(i);
            normalX[i] = cos * p.normalX(i) - sin * p.normalY(i);
            normalY[i] = sin * p.normalX(i) + cos * p.normalY(i);
        }
    }

    /** Whether queries can answer with the body and its shape is known here. */
    static boolean isKnown(RigidBody body) {
        boolean isPlain =
                body.shape() instanceof Circle
                        || body.shape() instanceof Polygon polygon && polygon.radius() == 0;
        return isPlain && !body.isSensor() && body.isEnabled();
    }

    boolean isDisc() {
        return cornerX.length == 0;
    }

    /** The tolerance in m of an answer about points at a distance from the origin, m. */
    double slack(double... far) {
        double all = Math.abs(x) + Math.abs(y) + radius;
        for (double length : far) {
            all += Math.abs(length);
        }
        return ROUND_OFF * all;
    }

    /** The depth of a point inside the outline, m; negative outside. */
    double depth(double px, double py) {
        if (isDisc()) {
            return radius - Length.hypot(px - x, py - y);
        }
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < cornerX.length; i++) {
            double out = normalX[i] * (px - cornerX[i]) + normalY[i] * (py - cornerY[i]);
            least = Math.min(least, -out);
        }
        return least;
    }

    /** The overlap with a box along the best separating axis, m; negative if they are apart. */
    double overlap(Aabb box) {
        double least = Math.min(along(box, 1, 0), along(box, 0, 1));
        for (int i = 0; i < normalX.length; i++) {
            least = Math.min(least, along(box, normalX[i], normalY[i]));
        }
        return isDisc() ? Math.min(least, alongNearestCorner(box)) : least;
    }

    private double alongNearestCorner(Aabb box) {
        double nearX = Math.min(Math.max(x, box.minX), box.maxX);
        double nearY = Math.min(Math.max(y, box.minY), box.maxY);
        double distance = Length.hypot(nearX - x, nearY - y);
        return distance > 0
                ? along(box, (nearX - x) / distance, (nearY - y) / distance)
                : Double.POSITIVE_INFINITY;
    }

    /** Overlap of the two projections on an axis of length 1. */
    private double along(Aabb box, double axisX, double axisY) {
        double middle = axisX * (box.minX + box.maxX) / 2 + axisY * (box.minY + box.maxY) / 2;
        double half =
                Math.abs(axisX) * (box.maxX - box.minX) / 2
                        + Math.abs(axisY) * (box.maxY - box.minY) / 2;
        double least = reach(-axisX, -axisY);
        double most = reach(axisX, axisY);
        return Math.min(middle + half + least, most - (middle - half));
    }

    /** The support along a unit axis. */
    private double reach(double axisX, double axisY) {
        if (isDisc()) {
            return axisX * x + axisY * y + radius;
        }
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < cornerX.length; i++) {
            most = Math.max(most, axisX * cornerX[i] + axisY * cornerY[i]);
        }
        return most;
    }

    /**
     * The part of a segment that is inside, as two shares of it from 0 to 1; the first is greater
     * if there is none.
     */
    double[] inside(double fromX, double fromY, double alongX, double alongY) {
        return isDisc()
                ? insideDisc(fromX, fromY, alongX, alongY)
                : insidePolygon(fromX, fromY, alongX, alongY);
    }

    private double[] insideDisc(double fromX, double fromY, double alongX, double alongY) {
        double square = alongX * alongX + alongY * alongY;
        double middle = ((x - fromX) * alongX + (y - fromY) * alongY) / square;
        double aside = Length.hypot(fromX + middle * alongX - x, fromY + middle * alongY - y);
        double half = Math.sqrt((radius * radius - aside * aside) / square);
        return aside < radius ? new double[] {middle - half, middle + half} : new double[] {1, 0};
    }

    private double[] insidePolygon(double fromX, double fromY, double alongX, double alongY) {
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        for (int i = 0; i < cornerX.length; i++) {
            double speed = normalX[i] * alongX + normalY[i] * alongY;
            double out = normalX[i] * (fromX - cornerX[i]) + normalY[i] * (fromY - cornerY[i]);
            if (speed < 0) {
                enter = Math.max(enter, -out / speed);
            } else if (speed > 0) {
                leave = Math.min(leave, -out / speed);
            } else if (out > 0) {
                return new double[] {1, 0};
            }
        }
        return new double[] {enter, leave};
    }
}

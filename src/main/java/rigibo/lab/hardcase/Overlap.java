package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;

import java.util.List;

/**
 * How deep bodies overlap, by brute force and apart from the engine's own measure: every pair,
 * every edge, every corner.
 */
final class Overlap {

    private Outline[] outlines = new Outline[0];

    /** Deepest overlap of all pairs as a share of the smaller width of the two, 0 without any. */
    double deepestShare(List<RigidBody> bodies) {
        int count = bodies.size();
        if (outlines.length < count) {
            outlines = new Outline[count];
        }
        for (int i = 0; i < count; i++) {
            if (outlines[i] == null || outlines[i].shape != bodies.get(i).shape()) {
                outlines[i] = new Outline(bodies.get(i).shape());
            }
            outlines[i].place(bodies.get(i));
        }
        double deepest = 0;
        for (int i = 0; i < count; i++) {
            for (int j = i + 1; j < count; j++) {
                if (outlines[i].isNear(outlines[j])) {
                    deepest = Math.max(deepest, share(outlines[i], outlines[j]));
                }
            }
        }
        return deepest;
    }

    private static double share(Outline a, Outline b) {
        double depth = -separation(a, b);
        double width = Math.min(a.shape.smallestWidth(), b.shape.smallestWidth());
        return Math.max(depth, 0) / width;
    }

    /** Largest gap along any edge normal: below 0 the least depth; a bound of it above 0. */
    private static double separation(Outline a, Outline b) {
        if (a.isRound() && b.isRound()) {
            return Math.hypot(b.x - a.x, b.y - a.y) - a.round - b.round;
        }
        if (a.isRound()) {
            return b.gapTo(a.x, a.y) - a.round;
        }
        if (b.isRound()) {
            return a.gapTo(b.x, b.y) - b.round;
        }
        return Math.max(a.gapAlongNormals(b), b.gapAlongNormals(a));
    }

    /** A body's corners in the world. */
    private static final class Outline {
        final Shape shape;
        final double round;
        final double[] cornerX;
        final double[] cornerY;
        double x;
        double y;
        boolean moves;

        Outline(Shape shape) {
            this.shape = shape;
            round = shape instanceof Circle ? ((Circle) shape).radius() : 0;
            int corners = shape instanceof Polygon ? ((Polygon) shape).corners() : 0;
            cornerX = new double[corners];
            cornerY = new double[corners];
        }

        boolean isRound() {
            return cornerX.length == 0;
        }

        void place(RigidBody body) {
            x = body.x();
            y = body.y();
            moves = body.type() == BodyType.DYNAMIC;
            double cos = StrictMath.cos(body.angle());
            double sin = StrictMath.sin(body.angle());
            for (int i = 0; i < cornerX.length; i++) {
                double px = ((Polygon) shape).cornerX(i);
                double py = ((Polygon) shape).cornerY(i);
                cornerX[i] = x + cos * px - sin * py;
                cornerY[i] = y + sin * px + cos * py;
            }
        }

        boolean isNear(Outline other) {
            double dx = other.x - x;
            double dy = other.y - y;
            double reach = shape.boundingRadius() + other.shape.boundingRadius();
            return (moves || other.moves) && dx * dx + dy * dy < reach * reach;
        }

        /** Signed distance of a point from this polygon's outline, negative inside. */
        double gapTo(double px, double py) {
            double inside = Double.NEGATIVE_INFINITY;
            double outside = Double.POSITIVE_INFINITY;
            for (int i = 0; i < cornerX.length; i++) {
                int next = (i + 1) % cornerX.length;
                double ex = cornerX[next] - cornerX[i];
                double ey = cornerY[next] - cornerY[i];
                double square = ex * ex + ey * ey;
                double dx = px - cornerX[i];
                double dy = py - cornerY[i];
                inside = Math.max(inside, (dx * ey - dy * ex) / Math.sqrt(square));
                double along = Math.max(0, Math.min(1, (dx * ex + dy * ey) / square));
                outside = Math.min(outside, Math.hypot(dx - along * ex, dy - along * ey));
            }
            return inside < 0 ? inside : outside;
        }

        double gapAlongNormals(Outline other) {
            double widest = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < cornerX.length; i++) {
                int next = (i + 1) % cornerX.length;
                double ex = cornerX[next] - cornerX[i];
                double ey = cornerY[next] - cornerY[i];
                double nearest = Double.POSITIVE_INFINITY;
                for (int j = 0; j < other.cornerX.length; j++) {
                    double dx = other.cornerX[j] - cornerX[i];
                    double dy = other.cornerY[j] - cornerY[i];
                    nearest = Math.min(nearest, dx * ey - dy * ex);
                }
                widest = Math.max(widest, nearest / Math.sqrt(ex * ex + ey * ey));
                if (widest > 0) {
                    return widest;
                }
            }
            return widest;
        }
    }
}

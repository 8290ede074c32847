package rigibo.lab.truth;

import rigibo.backend.geometry.Shape;

/**
 * A body's outline in the world, and how far it is from another's: by every edge and every corner,
 * apart from any engine's own measure.
 */
public final class Outline {

    private final Shape shape;
    private final double round;
    private final double[] cornerX;
    private final double[] cornerY;
    private double x;
    private double y;

    /** Of a shape, at the origin until it is placed. */
    public Outline(Shape shape) {
        this.shape = shape;
        round = shape.outline().radius();
        int corners = shape.outline().corners();
        cornerX = new double[corners];
        cornerY = new double[corners];
        place(0, 0, 0);
    }

    /** What it is the outline of. */
    public Shape shape() {
        return shape;
    }

    /**
     * Puts it somewhere.
     *
     * @param metresX of the centre of mass
     * @param metresY of the centre of mass, up
     * @param angle rad, counter-clockwise
     */
    public void place(double metresX, double metresY, double angle) {
        x = metresX;
        y = metresY;
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        for (int i = 0; i < cornerX.length; i++) {
            double px = shape.outline().cornerX(i);
            double py = shape.outline().cornerY(i);
            cornerX[i] = x + cos * px - sin * py;
            cornerY[i] = y + sin * px + cos * py;
        }
    }

    /** No part of it is farther left, m. */
    double left() {
        return x - shape.boundingRadius();
    }

    /** No part of it is farther right, m. */
    double right() {
        return x + shape.boundingRadius();
    }

    /** Whether the circles around the two overlap: if not, they are apart. */
    public boolean isNear(Outline other) {
        double dx = other.x - x;
        double dy = other.y - y;
        double reach = shape.boundingRadius() + other.shape.boundingRadius();
        return dx * dx + dy * dy < reach * reach;
    }

    /**
     * Largest gap to another along any edge normal, m: below 0 the least depth of their overlap; a
     * bound of it above 0.
     */
    public double separation(Outline other) {
        if (isRound() && other.isRound()) {
            return Math.hypot(other.x - x, other.y - y) - round - other.round;
        }
        if (isRound()) {
            return other.gapTo(x, y) - round - other.round;
        }
        if (other.isRound()) {
            return gapTo(other.x, other.y) - round - other.round;
        }
        return Math.max(gapAlongNormals(other), other.gapAlongNormals(this)) - round - other.round;
    }

    private boolean isRound() {
        return cornerX.length == 1;
    }

    /** Signed distance of a point from this polygon's outline, negative inside. */
    private double gapTo(double px, double py) {
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

    private double gapAlongNormals(Outline other) {
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

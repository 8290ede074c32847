package rigibo.lab.truth;

import rigibo.backend.geometry.Outline;

/** A convex piece of an outline in the world. */
final class Piece {

    /** The overlap of two cores that round-off causes for two segments on one line, m. */
    private static final double IN_LINE = 1e-9;

    private final Outline outline;
    private final double round;
    private final double[] cornerX;
    private final double[] cornerY;

    Piece(Outline outline) {
        this.outline = outline;
        round = outline.radius();
        cornerX = new double[outline.corners()];
        cornerY = new double[outline.corners()];
    }

    /** Places its body, m. */
    void place(double x, double y, double cos, double sin) {
        for (int i = 0; i < cornerX.length; i++) {
            double px = outline.cornerX(i);
            double py = outline.cornerY(i);
            cornerX[i] = x + cos * px - sin * py;
            cornerY[i] = y + sin * px + cos * py;
        }
    }

    /** The separation as of {@link rigibo.lab.truth.Outline#separation}, m. */
    double separation(Piece other) {
        if (isRound() && other.isRound()) {
            double apart = Math.hypot(other.cornerX[0] - cornerX[0], other.cornerY[0] - cornerY[0]);
            return apart - round - other.round;
        }
        if (isRound()) {
            return other.gapTo(cornerX[0], cornerY[0]) - round - other.round;
        }
        if (other.isRound()) {
            return gapTo(other.cornerX[0], other.cornerY[0]) - round - other.round;
        }
        return gapOfCores(other) - round - other.round;
    }

    /** The distance of the two cores, which counts at round corners. */
    private double gapOfCores(Piece other) {
        double parted = Math.max(gapAlongNormals(other), other.gapAlongNormals(this));
        boolean isAsked = round + other.round > 0 && parted > -IN_LINE;
        return isAsked ? Math.max(parted, Math.min(nearest(other), other.nearest(this))) : parted;
    }

    /** The least distance of a corner of another core from this core, m. */
    private double nearest(Piece other) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < other.cornerX.length; i++) {
            least = Math.min(least, gapTo(other.cornerX[i], other.cornerY[i]));
        }
        return least;
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

    private double gapAlongNormals(Piece other) {
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

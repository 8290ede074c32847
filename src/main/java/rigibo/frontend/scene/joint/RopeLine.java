package rigibo.frontend.scene.joint;

/** The line along which a rope is drawn: straight where it is taut, sagging where it is slack. */
public final class RopeLine {

    private final double[] xy;
    private double nearestDistance;
    private double nearestWay;

    private RopeLine(double[] xy) {
        this.xy = xy;
    }

    /** A rope of a length between two points of the world, m. */
    public static RopeLine hanging(double x1, double y1, double x2, double y2, double length) {
        Strand strand = new Strand();
        strand.hang(x1, y1, x2, y2, length);
        double[] xy = new double[2 * strand.points()];
        for (int i = 0; i < strand.points(); i++) {
            xy[2 * i] = strand.x(i);
            xy[2 * i + 1] = strand.y(i);
        }
        return new RopeLine(xy);
    }

    /** Its points x₀, y₀, x₁, y₁, … in the world, m. */
    public double[] points() {
        return xy.clone();
    }

    /** Length of the line, m. */
    public double length() {
        double sum = 0;
        for (int i = 2; i < xy.length; i += 2) {
            sum += Math.hypot(xy[i] - xy[i - 2], xy[i + 1] - xy[i - 1]);
        }
        return sum;
    }

    /** Distance of a point from the line, m. */
    public double distance(double x, double y) {
        seek(x, y);
        return nearestDistance;
    }

    /** Position of the line's point nearest to a given one, as a share of its length, 0 to 1. */
    public double share(double x, double y) {
        seek(x, y);
        double length = length();
        return length > 0 ? nearestWay / length : 0;
    }

    private void seek(double x, double y) {
        nearestDistance = Double.POSITIVE_INFINITY;
        double way = 0;
        for (int i = 2; i < xy.length; i += 2) {
            double dx = xy[i] - xy[i - 2];
            double dy = xy[i + 1] - xy[i - 1];
            double square = dx * dx + dy * dy;
            double along = (x - xy[i - 2]) * dx + (y - xy[i - 1]) * dy;
            double share = square > 0 ? Math.max(0, Math.min(1, along / square)) : 0;
            double away = Math.hypot(x - xy[i - 2] - share * dx, y - xy[i - 1] - share * dy);
            double piece = Math.sqrt(square);
            if (away < nearestDistance) {
                nearestDistance = away;
                nearestWay = way + share * piece;
            }
            way += piece;
        }
    }

    /** World x of the point at a share of its length, 0 to 1, m. */
    public double x(double share) {
        return at(share, 0);
    }

    /** World y of the point at a share of its length, 0 to 1, m, up. */
    public double y(double share) {
        return at(share, 1);
    }

    private double at(double share, int axis) {
        double left = share * length();
        for (int i = 2; i < xy.length; i += 2) {
            double piece = Math.hypot(xy[i] - xy[i - 2], xy[i + 1] - xy[i - 1]);
            if (left <= piece && piece > 0) {
                return xy[i - 2 + axis] + left / piece * (xy[i + axis] - xy[i - 2 + axis]);
            }
            left -= piece;
        }
        return xy[xy.length - 2 + axis];
    }
}

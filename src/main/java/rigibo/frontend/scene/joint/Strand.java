package rigibo.frontend.scene.joint;

/** A line of many points, world m: a rope, a coil, an arc. */
final class Strand {

    private static final int ROPE_PIECES = 18;
    private static final int BISECTIONS = 30;

    /** Length of a coil of a spring without load, m, and the least and greatest number of coils. */
    private static final double COIL = 0.13;

    private static final int FEWEST_COILS = 4;
    private static final int MOST_COILS = 14;
    private static final int PIECES_OF_COIL = 16;

    /** The straight ends, and the coils' radius, as shares of the length without load. */
    private static final double STRAIGHT = 0.08;

    private static final double BREADTH = 0.16;
    private static final double THINNEST = 0.05;
    private static final double BROADEST = 0.13;

    /** An arrow about a pin goes so far round, rad. */
    private static final double ARC = 1.5 * Math.PI;

    private static final int ARC_PIECES = 20;

    /** Size of the arrow's head, as a share of the radius. */
    private static final double HEAD = 0.42;

    private double[] xy = new double[128];
    private double[] kept = new double[128];
    private int points;
    private int turns;

    /** A point along it, and the direction there. */
    double x;

    double y;
    double dx;
    double dy;

    int points() {
        return points;
    }

    double x(int point) {
        return xy[2 * point];
    }

    double y(int point) {
        return xy[2 * point + 1];
    }

    int turns() {
        return turns;
    }

    private void begin(int most) {
        points = 0;
        if (xy.length < 2 * most) {
            xy = new double[2 * most];
        }
    }

    private void add(double px, double py) {
        xy[2 * points] = px;
        xy[2 * points + 1] = py;
        points++;
    }

    double length() {
        double sum = 0;
        for (int i = 1; i < points; i++) {
            sum += Math.hypot(x(i) - x(i - 1), y(i) - y(i - 1));
        }
        return sum;
    }

    /** A rope between two points: a parabola as long as the rope, which hardly differs from it. */
    void hang(double x1, double y1, double x2, double y2, double length) {
        double low = 0;
        double high = length;
        sag(x1, y1, x2, y2, 0);
        boolean isTaut = length() >= length;
        for (int i = 0; i < BISECTIONS && !isTaut; i++) {
            double middle = (low + high) / 2;
            sag(x1, y1, x2, y2, middle);
            if (length() < length) {
                low = middle;
            } else {
                high = middle;
            }
        }
    }

    /** A line through given points. */
    void along(double[] given, int count) {
        begin(count);
        for (int i = 0; i < count; i++) {
            add(given[2 * i], given[2 * i + 1]);
        }
    }

    private void sag(double x1, double y1, double x2, double y2, double depth) {
        begin(ROPE_PIECES + 1);
        for (int i = 0; i <= ROPE_PIECES; i++) {
            double t = (double) i / ROPE_PIECES;
            add(x1 + t * (x2 - x1), y1 + t * (y2 - y1) - 4 * t * (1 - t) * depth);
        }
    }

    /** Finds the point at a distance (m) from the beginning. */
    void at(double way) {
        double left = way;
        for (int i = 1; i < points; i++) {
            double piece = Math.hypot(x(i) - x(i - 1), y(i) - y(i - 1));
            if (left <= piece || i == points - 1) {
                dx = piece > 0 ? (x(i) - x(i - 1)) / piece : 1;
                dy = piece > 0 ? (y(i) - y(i - 1)) / piece : 0;
                x = x(i - 1) + left * dx;
                y = y(i - 1) + left * dy;
                return;
            }
            left -= piece;
        }
    }

    /** A spring's wire from the side: a sine between two straight ends. */
    void coil(double x1, double y1, double x2, double y2, double rest) {
        turns = (int) Math.round(rest / COIL);
        turns = Math.max(FEWEST_COILS, Math.min(MOST_COILS, turns));
        double radius = Math.max(THINNEST, Math.min(BROADEST, BREADTH * rest));
        int pieces = turns * PIECES_OF_COIL;
        begin(pieces + 3);
        double length = Math.hypot(x2 - x1, y2 - y1);
        double ax = length > 0 ? (x2 - x1) / length : 0;
        double ay = length > 0 ? (y2 - y1) / length : 1;
        double end = STRAIGHT * length;
        add(x1, y1);
        for (int i = 0; i <= pieces; i++) {
            double way = end + (length - 2 * end) * i / pieces;
            double aside = radius * Math.sin(2 * Math.PI * i / PIECES_OF_COIL);
            add(x1 + way * ax - aside * ay, y1 + way * ay + aside * ax);
        }
        add(x2, y2);
        if (kept.length < xy.length) {
            kept = new double[xy.length];
        }
        System.arraycopy(xy, 0, kept, 0, 2 * points);
    }

    /** The part of a turn of the coil that is in front. */
    void front(int turn) {
        int quarter = PIECES_OF_COIL / 4;
        int first = 1 + turn * PIECES_OF_COIL + quarter;
        begin(2 * quarter + 1);
        for (int i = first; i <= first + 2 * quarter; i++) {
            add(kept[2 * i], kept[2 * i + 1]);
        }
    }

    /** Three quarters of a circle, in the direction that {@code way} tells. */
    void arc(double centreX, double centreY, double radius, double from, double way) {
        begin(ARC_PIECES + 1);
        for (int i = 0; i <= ARC_PIECES; i++) {
            double angle = from + way * ARC * i / ARC_PIECES;
            add(centreX + radius * Math.cos(angle), centreY + radius * Math.sin(angle));
        }
        x = x(ARC_PIECES);
        y = y(ARC_PIECES);
        double last = from + way * ARC;
        dx = -way * Math.sin(last);
        dy = way * Math.cos(last);
    }

    /** The head of the arrow whose arc was made last. */
    void arrow(double radius) {
        double back = HEAD * radius;
        begin(3);
        add(x - back * dx - back * dy, y - back * dy + back * dx);
        add(x, y);
        add(x - back * dx + back * dy, y - back * dy - back * dx);
    }
}

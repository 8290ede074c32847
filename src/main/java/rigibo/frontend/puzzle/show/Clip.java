package rigibo.frontend.puzzle.show;

/** Cuts lines to a rectangle (Liang and Barsky, A new concept and method for line clipping). */
final class Clip {

    private double left;
    private double top;
    private double right;
    private double bottom;

    /** Shares of the line at which it enters and leaves. */
    private double enters;

    private double leaves;

    /** Ends of the part of the last line that lies within the clip. */
    double fromX;

    double fromY;
    double toX;
    double toY;

    /** Sets the rectangle. */
    void to(double leftX, double topY, double rightX, double bottomY) {
        left = leftX;
        top = topY;
        right = rightX;
        bottom = bottomY;
    }

    /** Whether a point lies in the rectangle. */
    boolean holds(double x, double y) {
        return x >= left && x <= right && y >= top && y <= bottom;
    }

    /** Cuts a line; returns whether a part of it is left. */
    boolean cut(double x1, double y1, double x2, double y2) {
        enters = 0;
        leaves = 1;
        double dx = x2 - x1;
        double dy = y2 - y1;
        boolean isIn =
                meets(-dx, x1 - left)
                        && meets(dx, right - x1)
                        && meets(-dy, y1 - top)
                        && meets(dy, bottom - y1);
        fromX = x1 + enters * dx;
        fromY = y1 + enters * dy;
        toX = x1 + leaves * dx;
        toY = y1 + leaves * dy;
        return isIn && enters <= leaves;
    }

    /**
     * Cuts at one edge.
     *
     * @param speed at which the line leaves over it
     * @param room from the line's beginning to the edge, negative beyond it
     */
    private boolean meets(double speed, double room) {
        if (speed == 0) {
            return room >= 0;
        }
        if (speed < 0) {
            enters = Math.max(enters, room / speed);
        } else {
            leaves = Math.min(leaves, room / speed);
        }
        return true;
    }
}

package rigibo.frontend.draw;

import java.util.Arrays;

/** Rectangles in which something was drawn, logical px. */
final class Marks {

    private static final int SIDES = 4;

    /** Left, top, right and bottom edge of each rectangle. */
    private double[] sides = new double[64 * SIDES];

    private int used;

    void add(double left, double top, double right, double bottom) {
        if (used == sides.length) {
            sides = Arrays.copyOf(sides, 2 * used);
        }
        sides[used] = left;
        sides[used + 1] = top;
        sides[used + 2] = right;
        sides[used + 3] = bottom;
        used += SIDES;
    }

    /** Whether one of them reaches into a rectangle. */
    boolean meet(double left, double top, double right, double bottom) {
        for (int i = 0; i < used; i += SIDES) {
            if (sides[i] < right
                    && left < sides[i + 2]
                    && sides[i + 1] < bottom
                    && top < sides[i + 3]) {
                return true;
            }
        }
        return false;
    }

    void clear() {
        used = 0;
    }
}

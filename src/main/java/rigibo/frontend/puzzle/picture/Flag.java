package rigibo.frontend.puzzle.picture;

import rigibo.backend.geometry.Polygon;
import rigibo.frontend.puzzle.level.Platform;
import rigibo.frontend.scene.Skin;

import java.util.List;

/**
 * A place for the flag of a goal, of which {@link #best} finds the one where least of the cloth is
 * hidden behind bodies. The cloth hangs towards the goal's middle, so that it never leaves the
 * world.
 *
 * @param goal on which it stands
 * @param along the goal from its middle, m; positive to the right
 * @param height of the pole, m
 */
record Flag(Platform goal, double along, double height) {

    /** Width of the pole, m. */
    private static final double POLE = 0.08;

    /** Usual height of the pole, and those that look under or over what hides it, m. */
    private static final double[] HEIGHTS = {1.1, 0.8, 1.5};

    /** From the goal's end to the middle of the pole, m. */
    private static final double INSET = 0.09;

    /** Shares of the way from the goal's middle to a pole at its right end, the usual one first. */
    private static final double[] PLACES = {1, -1, 0.5, -0.5, 0};

    /** Width and height of the cloth, m; the width is less on a narrow goal. */
    private static final double CLOTH = 0.6;

    private static final double CLOTH_HEIGHT = 0.42;

    /** Rows of points, from the pole to the cloth's tip, that are asked whether they are hidden. */
    private static final int ROWS = 6;

    /**
     * The flag of which least is hidden; the usual one, at the goal's right end, if that may be.
     */
    static Flag best(Platform goal, List<Part> bodies) {
        Flag best = null;
        int least = Integer.MAX_VALUE;
        for (double height : HEIGHTS) {
            for (double place : PLACES) {
                Flag flag = new Flag(goal, place * (goal.width() / 2 - INSET), height);
                int hidden = flag.hiddenBehind(bodies);
                if (hidden < least) {
                    best = flag;
                    least = hidden;
                }
            }
        }
        return best;
    }

    /** The pole and the cloth, from back to front. */
    List<Part> parts() {
        // Counter-clockwise to either side.
        double half = Math.copySign(CLOTH_HEIGHT / 2, -tip());
        Polygon cloth = Polygon.of(0, -half, 0, half, tip(), 0);
        return List.of(
                new Part(Polygon.box(POLE, height), x(), y() + height / 2, 0, Skin.STONE),
                new Part(
                        cloth,
                        x() + cloth.centroidX(),
                        clothY() + cloth.centroidY(),
                        0,
                        Skin.GOAL));
    }

    /** How many of a few points of the cloth are behind bodies. */
    private int hiddenBehind(List<Part> bodies) {
        int hidden = 0;
        for (int row = 0; row < ROWS; row++) {
            double share = (row + 0.5) / ROWS;
            double rise = (1 - share) * CLOTH_HEIGHT / 2;
            for (int side = -1; side <= 1; side++) {
                double x = x() + share * tip();
                double y = clothY() + side * rise;
                if (bodies.stream().anyMatch(body -> body.covers(x, y))) {
                    hidden++;
                }
            }
        }
        return hidden;
    }

    /** The foot of the pole, m. */
    private double x() {
        double up = goal.height() / 2;
        return goal.x() + along * Math.cos(goal.angle()) - up * Math.sin(goal.angle());
    }

    private double y() {
        double up = goal.height() / 2;
        return goal.y() + along * Math.sin(goal.angle()) + up * Math.cos(goal.angle());
    }

    /** The y of the cloth's middle, m. */
    private double clothY() {
        return y() + height - CLOTH_HEIGHT / 2;
    }

    /** Where the tip of the cloth is, from the pole to the right, m; drafts may be narrow. */
    private double tip() {
        double room = Math.max(POLE, Math.abs(along) + goal.width() / 2 - INSET);
        return (along < 0 ? 1 : -1) * Math.min(CLOTH, room);
    }
}

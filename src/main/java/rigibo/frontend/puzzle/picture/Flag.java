package rigibo.frontend.puzzle.picture;

import rigibo.backend.geometry.Polygon;
import rigibo.frontend.puzzle.level.Platform;
import rigibo.frontend.scene.Skin;

import java.util.List;

/**
 * A place for the flag of a goal. {@link #best} finds the one where bodies hide least of the cloth.
 * The cloth hangs towards the goal's middle, so that it never leaves the world.
 *
 * @param goal on which it stands
 * @param along the goal from its middle, m; positive to the right
 * @param height of the pole, m
 */
record Flag(Platform goal, double along, double height) {

    /** Width of the pole, m. */
    private static final double POLE = 0.08;

    /** Usual height of the pole, then heights that look under or over a body in front, m. */
    private static final double[] HEIGHTS = {1.1, 0.8, 1.5};

    /** Distance from the goal's end to the middle of the pole, m. */
    private static final double INSET = 0.09;

    /**
     * Positions of the pole, as shares of the distance from the goal's middle to its right end; the
     * usual one first.
     */
    private static final double[] PLACES = {1, -1, 0.5, -0.5, 0};

    /** Width and height of the cloth, m; the width is less on a narrow goal. */
    private static final double CLOTH = 0.6;

    private static final double CLOTH_HEIGHT = 0.42;

    /** Rows of sample points, from the pole to the cloth's tip. */
    private static final int ROWS = 6;

    /** The flag that bodies hide least; among equals the usual one, at the goal's right end. */
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

    /** Number of sample points of the cloth that are behind bodies. */
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

    /** Position of the cloth's tip from the pole to the right, m; drafts may be narrow. */
    private double tip() {
        double room = Math.max(POLE, Math.abs(along) + goal.width() / 2 - INSET);
        return (along < 0 ? 1 : -1) * Math.min(CLOTH, room);
    }
}

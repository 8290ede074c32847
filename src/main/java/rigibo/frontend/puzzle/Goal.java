package rigibo.frontend.puzzle;

import rigibo.backend.geometry.Polygon;
import rigibo.frontend.puzzle.level.Platform;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Skin;

import java.util.List;

/**
 * The look of a level's goal: a chequered cushion, and a flag on its right end. The flag is only
 * drawn, behind all bodies, and its cloth hangs over the goal, so that it never leaves the world.
 */
public final class Goal {

    /** Width and height of the pole, m. */
    private static final double POLE = 0.08;

    private static final double POLE_HEIGHT = 1.1;

    /** From the goal's end to the middle of the pole, m. */
    private static final double INSET = 0.09;

    /** Width and height of the cloth, m; the width is less on a narrow goal. */
    private static final double CLOTH = 0.6;

    private static final double CLOTH_HEIGHT = 0.42;

    private Goal() {}

    /** The pole, the cloth and the cushion, from back to front. */
    static List<Part> parts(Platform goal) {
        double cos = Math.cos(goal.angle());
        double sin = Math.sin(goal.angle());
        double along = goal.width() / 2 - INSET;
        double up = goal.height() / 2;
        double x = goal.x() + along * cos - up * sin;
        double y = goal.y() + along * sin + up * cos;
        double width = Math.min(CLOTH, goal.width() - 2 * INSET);
        double half = CLOTH_HEIGHT / 2;
        Polygon cloth = Polygon.of(0, -half, 0, half, -width, 0);
        Polygon cushion = Polygon.box(goal.width(), goal.height());
        return List.of(
                new Part(Polygon.box(POLE, POLE_HEIGHT), x, y + POLE_HEIGHT / 2, 0, Skin.STONE),
                new Part(
                        cloth,
                        x + cloth.centroidX(),
                        y + POLE_HEIGHT - half + cloth.centroidY(),
                        0,
                        Skin.GOAL),
                new Part(cushion, goal.x(), goal.y(), goal.angle(), Skin.GOAL));
    }

    /** Draws it; what is drawn afterwards is before it. */
    public static void draw(Canvas canvas, Platform goal) {
        parts(goal).forEach(part -> part.draw(canvas));
    }
}

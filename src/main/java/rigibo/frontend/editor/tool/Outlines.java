package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.draft.Disc;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.List;

/** Draws outlines on the screen. */
public final class Outlines {

    private static final double WIDTH = 2.5;

    private Outlines() {}

    /** The outline of an item. */
    public static void draw(Canvas canvas, Camera camera, Item item, Color color) {
        if (item.form() instanceof Disc disc) {
            canvas.ring(
                    camera.screenX(item.place().x()),
                    camera.screenY(item.place().y()),
                    disc.radius() * camera.scale(),
                    WIDTH,
                    1,
                    color);
        }
        for (List<Point> line : item.lines()) {
            if (item.form().isOpen()) {
                drawOpen(canvas, camera, line, color);
            } else {
                draw(canvas, camera, line, color);
            }
        }
    }

    /** A closed line through corners, world m. */
    static void draw(Canvas canvas, Camera camera, List<Point> corners, Color color) {
        for (int i = 0; i < corners.size(); i++) {
            line(canvas, camera, corners.get(i), corners.get((i + 1) % corners.size()), color);
        }
    }

    private static void drawOpen(Canvas canvas, Camera camera, List<Point> corners, Color color) {
        for (int i = 0; i + 1 < corners.size(); i++) {
            line(canvas, camera, corners.get(i), corners.get(i + 1), color);
        }
    }

    static void line(Canvas canvas, Camera camera, Point a, Point b, Color color) {
        canvas.line(camera, a.x(), a.y(), b.x(), b.y(), WIDTH, color);
    }
}

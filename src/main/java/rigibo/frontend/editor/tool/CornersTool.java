package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Corners;
import rigibo.frontend.editor.draft.Grid;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;

import java.util.ArrayList;
import java.util.List;

/**
 * Sets the corners of a polygon, one per click; a click on the first corner, or Enter, closes it.
 */
public final class CornersTool implements Tool {

    /** How near to the first corner a click closes the polygon, px. */
    private static final double REACH = 10;

    private final Desk desk;
    private final List<Point> corners = new ArrayList<>();
    private Point pointer = new Point(0, 0);

    public CornersTool(Desk desk) {
        this.desk = desk;
    }

    @Override
    public void pressed(Point at) {
        pointer = at;
        boolean closes =
                !corners.isEmpty() && corners.get(0).minus(at).length() <= desk.metres(REACH);
        if (closes) {
            close();
        } else {
            corners.add(desk.grid().snap(at));
            if (corners.size() == Corners.MOST) {
                close();
            }
        }
    }

    private void close() {
        if (corners.size() < Corners.FEWEST) {
            return;
        }
        Point sum = corners.stream().reduce(new Point(0, 0), Point::plus);
        Point middle = Grid.ON.snap(sum.times(1.0 / corners.size()));
        desk.place(
                new Corners(corners.stream().map(corner -> corner.minus(middle)).toList()), middle);
        corners.clear();
    }

    @Override
    public void moved(Point at) {
        pointer = at;
    }

    @Override
    public boolean keyPressed(Key key) {
        if (corners.isEmpty()) {
            return false;
        }
        if (key == Key.ENTER) {
            close();
        } else if (key == Key.BACKSPACE) {
            corners.remove(corners.size() - 1);
        }
        return key == Key.ENTER || key == Key.BACKSPACE;
    }

    @Override
    public boolean cancelled() {
        boolean isDrawing = !corners.isEmpty();
        corners.clear();
        return isDrawing;
    }

    @Override
    public void draw(Canvas canvas) {
        Camera camera = desk.camera();
        for (int i = 0; i < corners.size(); i++) {
            Point corner = corners.get(i);
            Point next = i + 1 < corners.size() ? corners.get(i + 1) : desk.grid().snap(pointer);
            Outlines.line(canvas, camera, corner, next, Color.BRASS);
            double radius = i == 0 ? REACH : REACH / 2;
            double x = camera.screenX(corner.x());
            canvas.ring(x, camera.screenY(corner.y()), radius, 2, 1, Color.BRASS);
        }
    }
}

package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Corners;
import rigibo.frontend.editor.draft.Disc;
import rigibo.frontend.editor.draft.Form;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;

import java.util.List;

/** Draws a body by dragging; a click without dragging places one of the usual size. */
public final class DrawTool implements Tool {

    /** A way that no hand meant, px. */
    private static final double TREMBLING = 6;

    private final Desk desk;
    private final Stencil stencil;
    private int corners = 6;
    private Point from;
    private Point to;

    public DrawTool(Desk desk, Stencil stencil) {
        this.desk = desk;
        this.stencil = stencil;
    }

    @Override
    public void pressed(Point at) {
        from = at;
        to = at;
    }

    @Override
    public void moved(Point at) {
        to = at;
    }

    @Override
    public void released(Point at) {
        if (from == null) {
            return;
        }
        to = at;
        boolean isClick = to.minus(from).length() < desk.metres(TREMBLING);
        desk.history().begin();
        if (isClick) {
            desk.place(stencil.usual(corners), from);
            desk.item().map(desk.grid()::snap).ifPresent(desk::put);
        } else {
            Point start = desk.grid().snap(from);
            desk.place(form(), stencil.middle(start, way()), stencil.degrees(way()));
        }
        desk.history().end();
        from = null;
    }

    private Point way() {
        return desk.grid().snap(to).minus(desk.grid().snap(from));
    }

    private Form form() {
        return stencil.form(way(), corners);
    }

    @Override
    public boolean keyPressed(Key key) {
        boolean isCount = stencil == Stencil.REGULAR && (key == Key.UP || key == Key.DOWN);
        if (isCount) {
            int more = corners + (key == Key.UP ? 1 : -1);
            corners = Math.max(Corners.FEWEST, Math.min(Corners.MOST, more));
        }
        return isCount;
    }

    @Override
    public List<Key> keys() {
        return stencil == Stencil.REGULAR ? List.of(Key.DOWN, Key.UP) : List.of();
    }

    @Override
    public boolean cancelled() {
        boolean isDrawing = from != null;
        from = null;
        return isDrawing;
    }

    @Override
    public void draw(Canvas canvas) {
        if (from != null) {
            Point middle = stencil.middle(desk.grid().snap(from), way());
            outline(canvas, desk.camera(), middle, form(), stencil.degrees(way()));
        }
    }

    private static void outline(
            Canvas canvas, Camera camera, Point middle, Form form, double degrees) {
        if (form instanceof Disc disc) {
            double radius = disc.radius() * camera.scale();
            double x = camera.screenX(middle.x());
            canvas.ring(x, camera.screenY(middle.y()), radius, 2, 1, Color.BRASS);
        }
        Outlines.draw(
                canvas,
                camera,
                form.corners().stream().map(corner -> middle.plus(corner.turned(degrees))).toList(),
                Color.BRASS);
    }
}

package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Corners;
import rigibo.frontend.editor.draft.Form;
import rigibo.frontend.editor.draft.Grid;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Landscape;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;

import java.util.ArrayList;
import java.util.List;

/**
 * Sets the corners of a polygon or landscape, one per click. A click on the first corner closes it;
 * Enter closes a polygon, and ends a landscape where it is.
 */
public final class CornersTool implements Tool {

    /** How near to the first corner a click closes the polygon, px. */
    private static final double REACH = 10;

    /** The shape that the corners make. */
    public enum Kind {
        POLYGON(Corners.FEWEST, Corners.MOST),
        LANDSCAPE(Landscape.FEWEST, Landscape.MOST);

        private final int fewest;
        private final int most;

        Kind(int fewest, int most) {
            this.fewest = fewest;
            this.most = most;
        }
    }

    private final Desk desk;
    private final Kind kind;
    private final List<Point> corners = new ArrayList<>();
    private Point pointer = new Point(0, 0);

    public CornersTool(Desk desk, Kind kind) {
        this.desk = desk;
        this.kind = kind;
    }

    @Override
    public void pressed(Point at) {
        pointer = at;
    }

    /** A corner is where the button goes up: a finger slides until it is right. */
    @Override
    public void released(Point at) {
        pointer = at;
        boolean closes =
                !corners.isEmpty() && corners.get(0).minus(at).length() <= desk.reach(REACH);
        if (closes) {
            finish(true);
        } else {
            corners.add(desk.grid().snap(at));
            if (corners.size() == kind.most) {
                finish(kind == Kind.POLYGON);
            }
        }
    }

    private void finish(boolean isClosed) {
        if (corners.size() < (isClosed ? Corners.FEWEST : kind.fewest)) {
            return;
        }
        Point sum = corners.stream().reduce(new Point(0, 0), Point::plus);
        Point middle = Grid.ON.snap(sum.times(1.0 / corners.size()));
        List<Point> own = corners.stream().map(corner -> corner.minus(middle)).toList();
        desk.place(form(own, middle, isClosed), middle);
        corners.clear();
    }

    private Form form(List<Point> own, Point middle, boolean isClosed) {
        if (kind == Kind.POLYGON) {
            return new Corners(own).whole();
        }
        Point ball = desk.draft().item("/ball").map(Item::place).orElse(middle);
        return isClosed ? Landscape.loop(own, ball.minus(middle)) : Landscape.ground(own);
    }

    @Override
    public void moved(Point at) {
        pointer = at;
    }

    /** The corners that were set stay. */
    @Override
    public void interrupted() {}

    @Override
    public boolean keyPressed(Key key) {
        if (corners.isEmpty()) {
            return false;
        }
        if (key == Key.ENTER) {
            finish(kind == Kind.POLYGON);
        } else if (key == Key.BACKSPACE) {
            corners.remove(corners.size() - 1);
        }
        return key == Key.ENTER || key == Key.BACKSPACE;
    }

    @Override
    public List<Key> keys() {
        return corners.isEmpty() ? List.of() : List.of(Key.ENTER, Key.BACKSPACE);
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

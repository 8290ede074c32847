package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.Comparator;
import java.util.Optional;
import java.util.function.Function;

/** Chooses, drags, turns and sizes. */
public final class SelectTool implements Tool {

    /** How near to a handle the pointer takes hold of it, px. */
    private static final double REACH = 11;

    private final Desk desk;
    private Function<Point, Item> drag;

    public SelectTool(Desk desk) {
        this.desk = desk;
    }

    @Override
    public void pressed(Point at) {
        Optional<Handle> handle = handleAt(at);
        if (handle.isPresent()) {
            drag = handle.get().moved();
        } else {
            Optional<Item> under = desk.at(at);
            desk.choose(under.map(Item::pointer).orElse(""));
            drag = under.map(item -> along(item, at)).orElse(null);
        }
        if (drag != null) {
            desk.history().begin();
        }
    }

    private Function<Point, Item> along(Item item, Point from) {
        return to -> desk.grid().snap(item.at(item.place().plus(to.minus(from))));
    }

    private Optional<Handle> handleAt(Point at) {
        return desk.item().stream()
                .flatMap(item -> Handles.of(desk, item).stream())
                .filter(handle -> handle.at().minus(at).length() <= desk.metres(REACH))
                .min(Comparator.comparingDouble(handle -> handle.at().minus(at).length()));
    }

    @Override
    public void moved(Point at) {
        if (drag != null) {
            desk.put(drag.apply(at));
        }
    }

    @Override
    public void released(Point at) {
        drag = null;
        desk.history().end();
    }

    @Override
    public boolean cancelled() {
        boolean isDragging = drag != null;
        drag = null;
        desk.history().cancel();
        return isDragging;
    }

    @Override
    public void draw(Canvas canvas) {
        desk.item()
                .ifPresent(
                        item -> {
                            for (Handle handle : Handles.of(desk, item)) {
                                draw(canvas, item, handle);
                            }
                        });
    }

    private void draw(Canvas canvas, Item item, Handle handle) {
        Camera camera = desk.camera();
        double x = camera.screenX(handle.at().x());
        double y = camera.screenY(handle.at().y());
        if (handle.kind() == Handle.Kind.TURN) {
            double fromX = camera.screenX(item.place().x());
            double fromY = camera.screenY(item.place().y());
            canvas.line(fromX, fromY, x, y, 2, Color.BRASS);
            canvas.disc(x, y, 8, Color.DUSK_TOP);
            canvas.ring(x, y, 7, 3, 1, Color.BRASS);
        } else {
            canvas.disc(x, y, 7, Color.DUSK_TOP);
            canvas.disc(x, y, 5, Color.TEXT);
        }
    }
}

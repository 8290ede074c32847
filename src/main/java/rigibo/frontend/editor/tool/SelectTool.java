package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.desk.Joining;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.JointEntry;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.Comparator;
import java.util.Optional;
import java.util.function.Consumer;

/** Selects, drags, turns and resizes. */
public final class SelectTool implements Tool {

    /** How near to a handle the pointer takes hold of it, px. */
    private static final double REACH = 11;

    /** A way that no hand meant: a click on a pin leaves it where it is, px. */
    private static final double TREMBLING = 4;

    private final Desk desk;
    private final Joining joining;
    private Consumer<Point> drag;
    private Runnable click;
    private boolean isDragged;

    /** The selection before the button went down. */
    private String before = "";

    /** The joint that this tool chose, for one that was just made is not clicked twice. */
    private String clicked = "";

    public SelectTool(Desk desk) {
        this.desk = desk;
        joining = new Joining(desk);
    }

    @Override
    public void pressed(Point at) {
        Optional<Handle> handle = handleAt(at);
        Optional<JointEntry> joint = joining.at(at);
        click = null;
        isDragged = false;
        before = desk.chosen();
        if (handle.isPresent()) {
            drag = to -> desk.put(handle.get().moved().apply(to));
        } else if (joint.isPresent()) {
            press(joint.get(), at);
        } else {
            Optional<Item> under = desk.at(at);
            choose(under);
            drag = under.map(item -> along(item, at)).orElse(null);
        }
        if (drag != null) {
            desk.history().begin();
        }
    }

    /** A second click on a joint selects the thing under the joint. */
    private void press(JointEntry joint, Point at) {
        if (joint.pointer().equals(desk.chosen()) && desk.chosen().equals(clicked)) {
            click = () -> choose(desk.at(at));
        }
        clicked = joint.pointer();
        desk.choose(joint.pointer());
        drag = joining.anchorAt(at).map(anchor -> along(anchor, at)).orElse(null);
    }

    private Consumer<Point> along(Joining.Anchor anchor, Point from) {
        return to -> {
            isDragged |= to.minus(from).length() >= desk.metres(TREMBLING);
            if (isDragged) {
                joining.move(anchor, to);
            }
        };
    }

    private void choose(Optional<Item> item) {
        desk.choose(item.map(Item::pointer).orElse(""));
    }

    private Consumer<Point> along(Item item, Point from) {
        return to -> desk.put(desk.grid().snap(item.at(item.place().plus(to.minus(from)))));
    }

    private Optional<Handle> handleAt(Point at) {
        return desk.item().stream()
                .flatMap(item -> Handles.of(desk, item).stream())
                .filter(handle -> handle.at().minus(at).length() <= desk.reach(REACH))
                .filter(handle -> !desk.isInHand() || isNearer(handle, at))
                .min(Comparator.comparingDouble(handle -> handle.at().minus(at).length()));
    }

    /**
     * A thing as small as a finger has no handles: they would take all touches, and it could not be
     * dragged.
     */
    private boolean isNearer(Handle handle, Point at) {
        double middle = desk.item().orElseThrow().place().minus(at).length();
        return handle.at().minus(at).length() < middle;
    }

    @Override
    public void moved(Point at) {
        if (drag != null) {
            drag.accept(at);
        }
    }

    @Override
    public void released(Point at) {
        drag = null;
        desk.history().end();
        if (click != null && !isDragged) {
            click.run();
            clicked = "";
        }
        click = null;
    }

    @Override
    public boolean cancelled() {
        boolean isDragging = drag != null;
        drag = null;
        desk.history().cancel();
        return isDragging;
    }

    @Override
    public void interrupted() {
        cancelled();
        click = null;
        desk.choose(before);
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

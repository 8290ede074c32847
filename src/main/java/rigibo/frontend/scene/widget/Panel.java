package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Tap;

import java.util.List;

/**
 * A column of widgets on a dark plate. The owner passes on the input that it does not use itself.
 */
public final class Panel {

    private static final double PADDING = 12;
    private static final int NOTHING = -1;

    private double x;
    private double y;
    private double width;
    private final double gap;
    private final List<Widget> widgets;
    private int hot = NOTHING;
    private int dragged = NOTHING;

    /** Height of a row and gap between two rows as last drawn, px; number of columns. */
    private double row = Widget.ROW;

    private double space;
    private int columns = 1;

    /** Lowest end of the panel in a handheld window, px. */
    private double end = Double.POSITIVE_INFINITY;

    /** A panel with its upper left corner at (x, y), px. */
    public Panel(double x, double y, double width, List<Widget> widgets) {
        this(x, y, width, 0, widgets);
    }

    /** A panel that leaves a gap between its rows, px. */
    public Panel(double x, double y, double width, double gap, List<Widget> widgets) {
        this.x = x;
        this.y = y;
        this.width = width;
        this.gap = gap;
        space = gap;
        this.widgets = List.copyOf(widgets);
    }

    /** Returns this panel with other widgets; the selected or held row stays so. */
    public Panel with(List<Widget> others) {
        Panel panel = new Panel(x, y, width, gap, others);
        panel.hot = hot;
        panel.dragged = dragged;
        panel.row = row;
        panel.space = space;
        panel.columns = columns;
        return panel;
    }

    /** Moves it: its upper left corner, and its width, px. */
    public void place(double left, double top, double wide) {
        x = left;
        y = top;
        width = wide;
    }

    /** Moves it to the upper edge of a room, px; in a handheld window it stays within the room. */
    public void place(Plate room) {
        place(room.x(), room.y(), room.width());
        end = room.bottom();
    }

    /** Height with its padding, px. */
    public double height() {
        return rows() * pitch() + 2 * PADDING;
    }

    /** From the top of one row to that of the next, px. */
    private double pitch() {
        return row + space;
    }

    private int rows() {
        return (widgets.size() + columns - 1) / columns;
    }

    /** Draws the plate and its rows; in a handheld window in two columns where one is too high. */
    public void draw(Canvas canvas) {
        Layout layout = canvas.layout();
        row = widgets.stream().mapToDouble(widget -> widget.height(layout)).max().orElse(0);
        space = layout.isInHand() ? 0 : gap;
        columns = 1;
        if (layout.isInHand() && y + height() > Math.min(end, layout.seenBottom())) {
            columns = 2;
        }
        canvas.panel(x, y, width, height(), 12, Color.PANEL);
        for (int i = 0; i < widgets.size(); i++) {
            Plate place = place(i);
            widgets.get(i).draw(canvas, place.x(), place.y(), place.width(), i == hot);
            if (i == hot) {
                canvas.frame(
                        place.x() - 8, place.y() - 1, place.width() + 16, row + 2, 9, Color.BRASS);
            }
        }
    }

    /** Tells of its controls, where they were last drawn. */
    public void describe(Narrator narrator) {
        for (int i = 0; i < widgets.size(); i++) {
            widgets.get(i).describe(narrator, place(i), i == hot);
        }
    }

    /** Where a widget is: they follow each other downwards. */
    private Plate place(int widget) {
        double wide = (width - (columns + 1) * PADDING) / columns;
        return new Plate(
                x + PADDING + widget / rows() * (wide + PADDING),
                y + PADDING + widget % rows() * pitch() + space / 2,
                wide,
                row);
    }

    /** Whether a point lies on the plate. */
    public boolean contains(double px, double py) {
        return px >= x && px <= x + width && py >= y && py <= y + height();
    }

    /** When a finger at a point presses: at once on a slider's rail, since it is dragged. */
    public Tap tap(double px, double py) {
        int row = rowAt(px, py);
        return row != NOTHING && widgets.get(row).isDragged() ? Tap.AT_ONCE : Tap.LIFTED;
    }

    /** The pointer moved; drags the slider that is held. */
    public void pointerMoved(double px, double py) {
        if (dragged != NOTHING) {
            widgets.get(dragged).press(share(dragged, px));
            return;
        }
        int row = rowAt(px, py);
        hot = row != NOTHING && widgets.get(row).isControl() ? row : NOTHING;
    }

    /** The pointer went down; returns whether on the plate. */
    public boolean pointerPressed(double px, double py) {
        pointerMoved(px, py);
        if (hot != NOTHING) {
            // Comes first, since the press may put another panel in place of this one.
            dragged = widgets.get(hot).isDragged() ? hot : NOTHING;
            widgets.get(hot).press(share(hot, px));
        }
        return contains(px, py);
    }

    /** The pointer went up. */
    public void pointerReleased() {
        dragged = NOTHING;
    }

    /** Up and down choose a control, left, right and Enter use it; returns whether it was used. */
    public boolean keyPressed(Key key) {
        if (key == Key.UP || key == Key.DOWN) {
            choose(key == Key.UP ? -1 : 1);
            return true;
        }
        if (hot == NOTHING || key != Key.LEFT && key != Key.RIGHT && key != Key.ENTER) {
            return false;
        }
        widgets.get(hot).nudge(key == Key.LEFT ? -1 : 1);
        return true;
    }

    private void choose(int direction) {
        for (int i = 0; i < widgets.size(); i++) {
            hot =
                    Math.floorMod(
                            (hot == NOTHING && direction < 0 ? 0 : hot) + direction,
                            widgets.size());
            if (widgets.get(hot).isControl()) {
                return;
            }
        }
        hot = NOTHING;
    }

    private int rowAt(double px, double py) {
        for (int i = 0; i < widgets.size(); i++) {
            Plate place = place(i);
            boolean isBeside = columns == 1 || px >= place.x() - PADDING / 2;
            boolean isOn =
                    isBeside
                            && px <= place.right() + PADDING
                            && py >= place.y()
                            && py < place.bottom();
            if (isOn && contains(px, py)) {
                return i;
            }
        }
        return NOTHING;
    }

    /** Where an x is on a widget, 0 to 1. */
    private double share(int widget, double px) {
        Plate place = place(widget);
        return Math.max(0, Math.min(1, (px - place.x()) / place.width()));
    }
}

package rigibo.frontend.puzzle.hud;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

/**
 * Positions of the panels in a handheld window, logical px: above and below the scene if the window
 * is upright, beside it otherwise.
 *
 * @param bar title, counts and state of the game
 * @param keys the grid of the buttons
 * @param hint position and width of the level's hint
 */
record HandPlaces(Plate bar, Grid keys, Plate hint) {

    private static final double GAP = 8;

    /**
     * Height of a line of small text, px, and the number of lines of a bar, upright and landscape.
     */
    static final double LINE = 22;

    private static final int LINES = 3;
    private static final int LINES_LYING = 8;

    /** Buttons side by side. */
    private static final int UPRIGHT = 4;

    private static final int LYING = 2;

    static HandPlaces of(Layout layout, int buttons) {
        return layout.isUpright() ? upright(layout, buttons) : lying(layout, buttons);
    }

    private static HandPlaces upright(Layout layout, int buttons) {
        double left = layout.seenLeft() + GAP;
        double width = layout.seenRight() - GAP - left;
        Plate bar =
                new Plate(
                        left,
                        layout.seenTop() + GAP,
                        width,
                        LINES * layout.lettered(LINE) + 2 * GAP);
        Plate row = new Plate(left, 0, width, layout.clickable(0));
        Plate hint = new Plate(left, bar.bottom() + GAP, width, 0);
        return new HandPlaces(bar, keys(layout, row, UPRIGHT, buttons), hint);
    }

    private static HandPlaces lying(Layout layout, int buttons) {
        double left = layout.seenLeft() + GAP;
        double right = Scene.WIDTH + GAP;
        Plate bar =
                new Plate(
                        left,
                        layout.seenTop() + GAP,
                        -GAP - left,
                        LINES_LYING * layout.lettered(LINE) + 2 * GAP);
        Plate row = new Plate(right, 0, layout.seenRight() - GAP - right, layout.clickable(0));
        Plate hint = new Plate(left, bar.bottom() + GAP, bar.width(), 0);
        return new HandPlaces(bar, keys(layout, row, LYING, buttons), hint);
    }

    /** The grid of the keys, at the lower edge of the visible area. */
    private static Grid keys(Layout layout, Plate row, int columns, int buttons) {
        Grid anywhere = Grid.of(row, columns, GAP);
        double top = layout.seenBottom() - GAP - anywhere.height(buttons);
        return Grid.of(new Plate(row.x(), top, row.width(), row.height()), columns, GAP);
    }
}

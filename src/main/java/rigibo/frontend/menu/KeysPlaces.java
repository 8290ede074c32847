package rigibo.frontend.menu;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

/**
 * Where the parts of the page of keys are, logical px; in a handheld window, px of a sheet.
 *
 * @param levels the actions of levels
 * @param demos the actions that only demos have
 * @param told the line that tells what happened
 * @param reset the button that restores the default keys
 * @param back the button that leads back
 */
record KeysPlaces(Grid levels, Grid demos, Plate told, Plate reset, Plate back) {

    private static final double EDGE = 24;
    private static final double GAP = 16;
    private static final double TOP = 150;
    private static final double COLUMN = (Scene.WIDTH - 2 * EDGE - GAP) / 2;
    private static final double TILE = 38;
    private static final double BETWEEN = 6;
    private static final double BUTTONS = 676;

    /** Number of actions above the line that tells what happened. */
    private static final int ACTIONS = 10;

    private static final double TOLD = 62;

    private static final double GAP_IN_HAND = 8;
    private static final double BETWEEN_IN_HAND = 3.5;
    private static final double HEADING = 22;

    /** Height of four lines of text, px. */
    private static final double MOST_TOLD = 100;

    /** The places in a desktop window. */
    static final KeysPlaces ON_A_DESK = onADesk();

    static KeysPlaces of(Layout layout) {
        return layout.choose(ON_A_DESK, KeysPlaces::inHand, KeysPlaces::inHand);
    }

    private static KeysPlaces onADesk() {
        double right = EDGE + COLUMN + GAP;
        Grid levels = new Grid(new Plate(EDGE, TOP, COLUMN, TILE), 1, 0, BETWEEN);
        Plate end = levels.place(ACTIONS);
        return new KeysPlaces(
                levels,
                new Grid(new Plate(right, TOP, COLUMN, TILE), 1, 0, BETWEEN),
                new Plate(EDGE, end.y() + 3, Scene.WIDTH - 2 * EDGE, TOLD),
                new Plate(EDGE, BUTTONS, COLUMN, TILE),
                new Plate(right, BUTTONS, COLUMN, TILE));
    }

    /**
     * Buttons above, then the actions of levels beside those of demos, and the line of text below.
     */
    private static KeysPlaces inHand(Layout sheet) {
        double finger = sheet.clickable(0);
        Plate seen = Plate.seen(sheet, GAP_IN_HAND);
        Plate row = new Plate(seen.x(), seen.y(), seen.width(), finger);
        Grid halves = Grid.of(row, 2, GAP_IN_HAND);
        double top = row.bottom() + GAP_IN_HAND / 2 + HEADING;
        Grid levels = column(sheet, halves.place(0), top);
        double end = top + levels.height(ACTIONS) + GAP_IN_HAND / 2;
        double rest = sheet.seenBottom() - GAP_IN_HAND / 2 - end;
        return new KeysPlaces(
                levels,
                column(sheet, halves.place(1), top),
                new Plate(seen.x(), end, seen.width(), Math.min(MOST_TOLD, rest)),
                halves.place(1),
                halves.place(0));
    }

    /** Actions below a button; in two columns in a window that lies. */
    private static Grid column(Layout sheet, Plate button, double top) {
        Plate row = new Plate(button.x(), top, button.width(), button.height());
        Plate first = Grid.of(row, sheet.isUpright() ? 1 : 2, GAP_IN_HAND).first();
        return new Grid(first, sheet.isUpright() ? 1 : 2, GAP_IN_HAND, BETWEEN_IN_HAND);
    }
}

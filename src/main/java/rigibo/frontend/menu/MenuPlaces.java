package rigibo.frontend.menu;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

/**
 * Where the parts of the menu are, logical px.
 *
 * @param head the heading, from the middle of the title to the middle of the tagline
 * @param play the button that opens the next level
 * @param row the buttons below it
 * @param heading the heading above the cards, by its left end and its middle
 * @param cards the first card, and how the others follow
 */
record MenuPlaces(Plate head, Plate play, Plate row, Plate heading, Grid cards) {

    private static final double GAP = 12;

    /** The places in a desktop window. */
    static final MenuPlaces ON_A_DESK =
            new MenuPlaces(
                    new Plate(0, 84, Scene.WIDTH, 68),
                    new Plate(120, 190, 480, 84),
                    new Plate(34, 286, 652, 48),
                    new Plate(40, 368, 0, 0),
                    new Grid(new Plate(34, 386, 320, 46), 2, GAP, 6));

    /** From the upper edge to the middle of the title, and from there to that of the tagline. */
    private static final double TITLE = 66;

    private static final double TAGLINE = 74;

    /** Height of the head in a handheld window, in lines. */
    private static final double LINES = 2;

    /**
     * Height of a line of small text, px; and height of the button to play, as a multiple of the
     * other buttons'.
     */
    private static final double LINE = 22;

    private static final double PLAY = 1.3;

    static MenuPlaces of(Layout layout) {
        return layout.choose(ON_A_DESK, MenuPlaces::upright, MenuPlaces::lying);
    }

    /** Everything below each other. */
    private static MenuPlaces upright(Layout layout) {
        Plate seen = Plate.seen(layout, GAP);
        Plate head = new Plate(seen.x(), layout.seenTop() + TITLE, seen.width(), TAGLINE);
        Plate row = row(layout, head);
        Plate heading = new Plate(seen.x(), row.bottom() + layout.lettered(LINE), 0, 0);
        double top = heading.y() + layout.lettered(LINE) - 6;
        Grid cards = cards(layout, seen.x(), top, seen.width());
        return new MenuPlaces(head, play(layout, head), row, heading, cards);
    }

    /** The title and the levels on the left, all else on the right. */
    private static MenuPlaces lying(Layout layout) {
        double left = layout.seenLeft() + GAP;
        double half = (layout.seenRight() - layout.seenLeft()) / 2 - 1.5 * GAP;
        double middle = left + half + GAP;
        Plate head = new Plate(left, layout.seenTop() + 2 * TITLE, half, TAGLINE);
        Plate heading = new Plate(middle, layout.seenTop() + layout.lettered(LINE), 0, 0);
        double top = heading.y() + layout.lettered(LINE) - 6;
        return new MenuPlaces(
                head,
                play(layout, head),
                row(layout, head),
                heading,
                cards(layout, middle, top, half));
    }

    private static Plate play(Layout layout, Plate head) {
        return head.below(LINES * layout.lettered(LINE), PLAY * layout.clickable(0));
    }

    private static Plate row(Layout layout, Plate head) {
        return play(layout, head).below(GAP, layout.clickable(0));
    }

    private static Grid cards(Layout layout, double x, double y, double width) {
        return Grid.of(new Plate(x, y, width, layout.clickable(0)), 2, GAP / 2);
    }
}

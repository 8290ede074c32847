package rigibo.frontend.puzzle;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

/**
 * Positions of the parts of the scene of a level made by chance, logical px.
 *
 * @param back the way back
 * @param title the middle of the heading
 * @param picture of the level, or of the note until it is made
 * @param play the row of buttons for the level
 * @param results of earlier levels; as high as they need where there is room
 * @param head from the plate's edge to the middle of its heading, and from the last line to its
 *     other edge
 * @param row height of a line of results
 */
record MadePlaces(
        Plate back,
        Plate title,
        Plate picture,
        Plate play,
        Plate results,
        double head,
        double row) {

    private static final double EDGE = 20;
    private static final double GAP = 10;
    private static final double PICTURE = 330;
    private static final double BUTTON = 42;
    private static final double HEAD = 28;
    private static final double ROW = 30;

    /** Distance between the buttons of the row, px. */
    private static final double APART = 16;

    /** Height of the heading, px. */
    private static final double TITLE = 44;

    /** Largest share of a landscape window for the picture. */
    private static final double PICTURE_SHARE = 0.5;

    /** The positions in a desktop window. */
    static final MadePlaces ON_A_DESK = onADesk();

    private static MadePlaces onADesk() {
        Plate picture = new Plate((Scene.WIDTH - PICTURE) / 2, 84, PICTURE, PICTURE);
        Plate play = picture.below(14, BUTTON);
        double results = play.bottom() + 22;
        return new MadePlaces(
                new Plate(EDGE, 22, 130, BUTTON),
                new Plate(Scene.WIDTH / 2.0, 44, 0, 0),
                picture,
                play,
                new Plate(EDGE, results, Scene.WIDTH - 2 * EDGE, Scene.HEIGHT - EDGE - results),
                HEAD,
                ROW);
    }

    /** The positions in a window. */
    static MadePlaces of(Layout layout) {
        return layout.choose(ON_A_DESK, MadePlaces::upright, MadePlaces::lying);
    }

    private static MadePlaces upright(Layout layout) {
        double finger = layout.clickable(0);
        Plate seen = Plate.seen(layout, GAP);
        double left = seen.x();
        double width = seen.width();
        Plate back = new Plate(left, seen.y(), width / 2, finger);
        Plate title = heading(layout, left, back.bottom(), width);
        Plate picture = new Plate(left, title.y() + title.height(), width, PICTURE * 1.4);
        Plate play = picture.below(GAP, finger);
        return new MadePlaces(
                back,
                title,
                picture,
                play,
                below(seen, play),
                layout.lettered(HEAD),
                layout.lettered(ROW));
    }

    private static MadePlaces lying(Layout layout) {
        double finger = layout.clickable(0);
        Plate seen = Plate.seen(layout, GAP);
        double share = PICTURE_SHARE * (layout.seenRight() - layout.seenLeft());
        Plate picture = new Plate(seen.x(), seen.y(), share, seen.height());
        double aside = picture.right() + GAP;
        double width = seen.right() - aside;
        Plate back = new Plate(aside, seen.y(), width / 2, finger);
        Plate title = heading(layout, aside, back.bottom(), width);
        Plate play = new Plate(aside, title.y() + title.height(), width, finger);
        return new MadePlaces(
                back,
                title,
                picture,
                play,
                below(seen, play),
                layout.lettered(HEAD),
                layout.lettered(ROW));
    }

    private static Plate heading(Layout layout, double left, double above, double width) {
        double height = layout.lettered(TITLE);
        return new Plate(left + width / 2, above + height / 2, 0, height / 2);
    }

    private static Plate below(Plate seen, Plate play) {
        return play.below(GAP, seen.bottom() - GAP - play.bottom());
    }

    /**
     * Position of one of one or two buttons in the row: each takes half of it, a single one its
     * middle.
     */
    Plate button(int index, int count) {
        Plate half = Grid.of(play, 2, APART).place(index);
        double middle = play.x() + (play.width() - half.width()) / 2;
        return count == 1 ? new Plate(middle, half.y(), half.width(), half.height()) : half;
    }

    /** Number of lines of results that fit below their heading. */
    int rows() {
        return (int) ((results.height() - 2 * head) / row);
    }
}

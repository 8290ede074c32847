package rigibo.frontend.menu;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

/**
 * Where the parts of the list of levels are, logical px.
 *
 * @param title the middle of the heading; in a handheld window there is none
 * @param count the right end of the number of solved levels
 * @param buttons the button that leads back, and the others after it
 * @param made the row of levels made by chance
 * @param tabs the tabs of the worlds
 * @param cards the cards of the levels
 * @param world the plate about the world
 * @param foot the words about the selected level
 * @param watch the button that shows its best run, which may take room from the foot
 */
record LevelsPlaces(
        Plate title,
        Plate count,
        Grid buttons,
        Plate made,
        Grid tabs,
        Grid cards,
        Plate world,
        Plate foot,
        Plate watch) {

    private static final double EDGE = 20;
    private static final double GAP = 10;

    /** Slot of the plate among those of cards, after the tenth; it takes two of them. */
    private static final int PLATE_SLOT = 10;

    /** Rows of cards in a window that is held upright, and columns of it and of one that lies. */
    private static final int ROWS = 4;

    private static final int COLUMNS = 3;
    private static final int COLUMNS_LYING = 4;
    private static final int WORLDS = 4;

    /** Most of the height of a card for each px of width. */
    private static final double HIGHEST = 1.1;

    /** Height of the foot's two lines, px. */
    private static final double FOOT = 52;

    private static final double WATCH = 222;

    /** The share of an upright window for the way to watch. */
    private static final double WATCH_SHARE = 0.36;

    /** The share of a lying window that is left to all but the cards. */
    private static final double ASIDE = 0.37;

    /** The places in a desktop window. */
    static final LevelsPlaces ON_A_DESK = onADesk();

    private static LevelsPlaces onADesk() {
        Plate row = new Plate(EDGE, 128, Scene.WIDTH - 2 * EDGE, 54);
        Grid cards =
                new Grid(
                        new Plate(EDGE, row.bottom() + GAP, LevelCard.WIDTH, LevelCard.HEIGHT),
                        4,
                        GAP,
                        GAP);
        return new LevelsPlaces(
                new Plate(Scene.WIDTH / 2.0, 44, 0, 0),
                new Plate(Scene.WIDTH - EDGE, 46, 0, 0),
                new Grid(new Plate(EDGE, 22, 130, 42), 2, GAP, GAP),
                new Plate(EDGE, 74, Scene.WIDTH - 2 * EDGE, 42),
                Grid.of(row, WORLDS, GAP),
                cards,
                afterTheTenth(cards),
                new Plate(EDGE, Scene.HEIGHT - 60, Scene.WIDTH - 2 * EDGE, FOOT),
                new Plate(Scene.WIDTH - EDGE - WATCH, Scene.HEIGHT - 60, WATCH, FOOT));
    }

    /**
     * The places in a window.
     *
     * @param hasMade whether there are levels made by chance; without them a handheld window has no
     *     row for them
     */
    static LevelsPlaces of(Layout layout, boolean hasMade) {
        return layout.choose(
                ON_A_DESK, hand -> upright(hand, hasMade), hand -> lying(hand, hasMade));
    }

    private static LevelsPlaces upright(Layout layout, boolean hasMade) {
        double finger = layout.clickable(0);
        Plate seen = Plate.seen(layout, GAP);
        double left = seen.x();
        double width = seen.width();
        Plate first = new Plate(left, seen.y(), width, finger);
        Plate made = first.below(GAP, finger);
        Plate tabs = (hasMade ? made : first).below(GAP, finger);
        double footHeight = Math.max(layout.lettered(FOOT), finger);
        Plate foot = new Plate(left, seen.bottom() - footHeight, width, footHeight);
        double room = foot.y() - tabs.bottom() - GAP;
        double card = (width - (COLUMNS - 1) * GAP) / COLUMNS;
        double height = Math.min(HIGHEST * card, room / ROWS - GAP);
        Grid cards =
                new Grid(new Plate(left, tabs.bottom() + GAP, card, height), COLUMNS, GAP, GAP);
        return new LevelsPlaces(
                Plate.NONE,
                new Plate(left + width - GAP, first.y() + finger / 2, 0, 0),
                Grid.of(new Plate(left, first.y(), 0.66 * width, finger), 2, GAP),
                made,
                Grid.of(tabs, WORLDS, GAP),
                cards,
                afterTheTenth(cards),
                foot,
                new Plate(
                        left + (1 - WATCH_SHARE) * width,
                        foot.y(),
                        WATCH_SHARE * width,
                        footHeight));
    }

    private static LevelsPlaces lying(Layout layout, boolean hasMade) {
        double finger = layout.clickable(0);
        Plate seen = Plate.seen(layout, GAP);
        double aside = ASIDE * (layout.seenRight() - layout.seenLeft());
        Plate first = new Plate(seen.x(), seen.y(), aside, finger);
        Plate made = first.below(GAP, finger);
        Plate tabs = (hasMade ? made : first).below(GAP, finger);
        double below = tabs.bottom() + GAP + finger + GAP;
        Plate watch = new Plate(seen.x(), seen.bottom() - finger, aside, finger);
        double cardsLeft = first.right() + GAP;
        double width = seen.right() - cardsLeft;
        double card = (width - (COLUMNS_LYING - 1) * GAP) / COLUMNS_LYING;
        double height = (seen.height() + GAP) / COLUMNS - GAP;
        Grid cards =
                new Grid(new Plate(cardsLeft, first.y(), card, height), COLUMNS_LYING, GAP, GAP);
        return new LevelsPlaces(
                Plate.NONE,
                Plate.NONE,
                Grid.of(first, 2, GAP),
                made,
                Grid.of(tabs, 2, GAP),
                cards,
                afterTheTenth(cards),
                new Plate(seen.x(), below, aside, watch.y() - GAP - below),
                watch);
    }

    /** The foot, narrowed where the button to watch is shown. */
    Plate foot(boolean canWatch) {
        boolean isCut = canWatch && watch.y() < foot.bottom();
        return isCut
                ? new Plate(foot.x(), foot.y(), watch.x() - GAP - foot.x(), foot.height())
                : foot;
    }

    /** Whether a point, px, lies on the foot or on the way to watch. */
    boolean isOnFoot(double x, double y) {
        return foot.contains(x, y) || watch.contains(x, y);
    }

    private static Plate afterTheTenth(Grid cards) {
        Plate one = cards.place(PLATE_SLOT);
        Plate next = cards.place(PLATE_SLOT + 1);
        return new Plate(one.x(), one.y(), next.right() - one.x(), one.height());
    }
}

package rigibo.frontend.gallery;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

/**
 * Where the parts of the gallery are, logical px; in a handheld window, px of a sheet.
 *
 * @param back the button that leads back
 * @param tabs the tabs of the sections
 * @param pagers the buttons that turn pages
 * @param cards the cards of the exhibits
 * @param rows number of rows of cards on a page
 * @param count right end of the number of exhibits; in a handheld window the middle of the page
 *     number
 * @param foot the place for words about the selected exhibit; none in a handheld window, where no
 *     exhibit is pointed at
 */
record GalleryPlaces(
        Plate back, Grid tabs, Grid pagers, Grid cards, int rows, Plate count, Plate foot) {

    private static final double EDGE = 20;
    private static final double GAP = 10;
    private static final double TABS_TOP = 76;
    private static final double TAB = 36;
    private static final double TOP = 124;
    private static final int COLUMNS = 4;
    private static final int ROWS = 4;
    private static final double CARD_HEIGHT = 144;
    private static final double FOOT_TOP = Scene.HEIGHT - 52;
    private static final double FOOT = 40;
    private static final double PAGER = 42;

    private static final double GAP_IN_HAND = 8;
    private static final int COLUMNS_UPRIGHT = 2;
    private static final double BACK = 100;

    /** Width of the page number between the pagers in a handheld window, px. */
    private static final double COUNT = 64;

    /** Least height of a card in a handheld window, px. */
    private static final double LEAST = 130;

    static GalleryPlaces of(Layout layout, int sections) {
        return layout.isInHand() ? inHand(layout, sections) : onADesk(sections);
    }

    static GalleryPlaces onADesk(int sections) {
        double inner = Scene.WIDTH - 2 * EDGE;
        double right = Scene.WIDTH - EDGE;
        Plate tabs = new Plate(EDGE, TABS_TOP, inner - 2 * (PAGER + GAP), TAB);
        Plate pager = new Plate(right - 2 * PAGER - GAP, TABS_TOP, PAGER, TAB);
        return new GalleryPlaces(
                new Plate(EDGE, 20, 130, 42),
                Grid.of(tabs, Math.max(1, sections), GAP),
                new Grid(pager, 2, GAP, 0),
                Grid.of(new Plate(EDGE, TOP, inner, CARD_HEIGHT), COLUMNS, GAP),
                ROWS,
                new Plate(right, 44, 0, 0),
                new Plate(EDGE, FOOT_TOP, inner, FOOT));
    }

    /**
     * A row of buttons, with a row of tabs below it in an upright window, and cards in the
     * remaining room.
     */
    private static GalleryPlaces inHand(Layout sheet, int sections) {
        double finger = sheet.clickable(0);
        Plate seen = Plate.seen(sheet, GAP_IN_HAND);
        double left = seen.x();
        double width = seen.width();
        Plate back = new Plate(left, seen.y(), BACK, finger);
        double paging = left + width - 2 * finger - COUNT;
        Grid pagers = new Grid(new Plate(paging, back.y(), finger, finger), 2, COUNT, 0);
        double row = back.bottom() + GAP_IN_HAND;
        double between = back.right() + GAP_IN_HAND;
        Plate tabs =
                sheet.isUpright()
                        ? new Plate(left, row, width, finger)
                        : new Plate(between, back.y(), paging - GAP_IN_HAND - between, finger);
        double top = sheet.isUpright() ? tabs.bottom() + GAP_IN_HAND : row;
        double room = sheet.seenBottom() - top;
        int rows = Math.max(1, (int) (room / (LEAST + GAP_IN_HAND)));
        Plate cards = new Plate(left, top, width, room / rows - GAP_IN_HAND);
        return new GalleryPlaces(
                back,
                Grid.of(tabs, Math.max(1, sections), GAP_IN_HAND / 2),
                pagers,
                Grid.of(cards, sheet.isUpright() ? COLUMNS_UPRIGHT : COLUMNS, GAP_IN_HAND),
                rows,
                new Plate(paging + finger + COUNT / 2, back.y() + finger / 2, 0, 0),
                Plate.NONE);
    }

    /** How many cards there are on a page. */
    int onAPage() {
        return rows * cards.columns();
    }
}

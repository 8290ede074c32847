package rigibo.frontend.menu;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Plate;

/**
 * Where the parts of the statistics are, logical px; in a handheld window, px of a sheet.
 *
 * @param title the middle of the heading, with the size of its letters as height
 * @param back the button that leads back
 * @param levels the numbers about levels
 * @param play the numbers about tries
 * @param days the numbers about daily levels
 * @param endless the numbers about endless levels
 */
record StatisticsPlaces(
        Plate title, Plate back, Plate levels, Plate play, Plate days, Plate endless) {

    private static final double LEVELS = 226;
    private static final double PLAY = 142;
    private static final double PLAY_IN_HAND = 124;
    private static final double DAYS = 198;
    private static final double ENDLESS = 52;
    private static final double GAP = 14;
    private static final double GAP_IN_HAND = 8;
    private static final double BACK = 120;
    private static final double TITLE_IN_HAND = 26;

    /** Share of a lying window for the levels, which have four columns beside the others' three. */
    private static final double LEVELS_SHARE = 0.53;

    /** The places in a desktop window. */
    static final StatisticsPlaces ON_A_DESK = onADesk();

    static StatisticsPlaces of(Layout layout) {
        return layout.choose(ON_A_DESK, StatisticsPlaces::upright, StatisticsPlaces::lying);
    }

    private static StatisticsPlaces onADesk() {
        Plate levels = new Plate(60, 90, Scene.WIDTH - 2 * 60, LEVELS);
        Plate play = levels.below(GAP, PLAY);
        Plate days = play.below(GAP, DAYS);
        return new StatisticsPlaces(
                new Plate(Scene.WIDTH / 2.0, 44, 0, 36),
                new Plate(20, 22, 130, 42),
                levels,
                play,
                days,
                days.below(GAP, ENDLESS));
    }

    /** One plate below the other. */
    private static StatisticsPlaces upright(Layout sheet) {
        Plate seen = Plate.seen(sheet, GAP_IN_HAND);
        Plate back = back(sheet, seen);
        Plate levels = new Plate(seen.x(), back.bottom() + GAP_IN_HAND, seen.width(), LEVELS);
        Plate play = levels.below(GAP_IN_HAND, PLAY_IN_HAND);
        Plate days = play.below(GAP_IN_HAND, DAYS);
        Plate endless = days.below(GAP_IN_HAND, ENDLESS);
        return new StatisticsPlaces(title(seen, back), back, levels, play, days, endless);
    }

    /** The levels on the left, above those without end, and the rest on the right. */
    private static StatisticsPlaces lying(Layout sheet) {
        Plate seen = Plate.seen(sheet, GAP_IN_HAND);
        Plate back = back(sheet, seen);
        double top = back.bottom() + GAP_IN_HAND;
        double width = (1 - LEVELS_SHARE) * seen.width();
        Plate levels = new Plate(seen.x(), top, seen.width() - width - GAP_IN_HAND, LEVELS);
        Plate play = new Plate(seen.right() - width, top, width, PLAY_IN_HAND);
        return new StatisticsPlaces(
                title(seen, back),
                back,
                levels,
                play,
                play.below(GAP_IN_HAND, DAYS),
                levels.below(GAP_IN_HAND, ENDLESS));
    }

    private static Plate back(Layout sheet, Plate seen) {
        return new Plate(seen.x(), seen.y(), BACK, sheet.clickable(0));
    }

    private static Plate title(Plate seen, Plate back) {
        double middle = (back.right() + seen.right()) / 2;
        return new Plate(middle, back.y() + back.height() / 2, 0, TITLE_IN_HAND);
    }
}

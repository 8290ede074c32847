package rigibo.frontend.menu;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Plate;

/**
 * Where the parts of the statistics are, logical px; in a hand, px of a sheet.
 *
 * @param title the middle of the heading, with the size of its letters as height
 * @param back the way back
 * @param levels what is told of the levels
 * @param play of the player's tries
 * @param days of the levels of the days
 * @param endless of the levels without end
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

    /** The scene as it is on a desk. */
    static final StatisticsPlaces ON_A_DESK = onADesk();

    static StatisticsPlaces of(Layout layout) {
        return layout.isInHand() ? inHand(layout) : ON_A_DESK;
    }

    private static StatisticsPlaces onADesk() {
        Plate levels = new Plate(60, 90, Scene.WIDTH - 2 * 60, LEVELS);
        Plate play = below(levels, GAP, PLAY);
        Plate days = below(play, GAP, DAYS);
        return new StatisticsPlaces(
                new Plate(Scene.WIDTH / 2.0, 44, 0, 36),
                new Plate(20, 22, 130, 42),
                levels,
                play,
                days,
                below(days, GAP, ENDLESS));
    }

    /** One plate below the other, or in two columns in a window that lies. */
    private static StatisticsPlaces inHand(Layout sheet) {
        double left = sheet.seenLeft() + GAP_IN_HAND;
        double right = sheet.seenRight() - GAP_IN_HAND;
        Plate back = new Plate(left, sheet.seenTop() + GAP_IN_HAND, BACK, sheet.clickable(0));
        double middle = (back.right() + right) / 2;
        Plate title = new Plate(middle, back.y() + back.height() / 2, 0, TITLE_IN_HAND);
        double top = back.bottom() + GAP_IN_HAND;
        if (sheet.isUpright()) {
            Plate levels = new Plate(left, top, right - left, LEVELS);
            Plate play = below(levels, GAP_IN_HAND, PLAY_IN_HAND);
            Plate days = below(play, GAP_IN_HAND, DAYS);
            Plate endless = below(days, GAP_IN_HAND, ENDLESS);
            return new StatisticsPlaces(title, back, levels, play, days, endless);
        }
        double width = (1 - LEVELS_SHARE) * (right - left);
        Plate levels = new Plate(left, top, right - left - width - GAP_IN_HAND, LEVELS);
        Plate play = new Plate(right - width, top, width, PLAY_IN_HAND);
        return new StatisticsPlaces(
                title,
                back,
                levels,
                play,
                below(play, GAP_IN_HAND, DAYS),
                below(levels, GAP_IN_HAND, ENDLESS));
    }

    private static Plate below(Plate upper, double gap, double height) {
        return new Plate(upper.x(), upper.bottom() + gap, upper.width(), height);
    }
}

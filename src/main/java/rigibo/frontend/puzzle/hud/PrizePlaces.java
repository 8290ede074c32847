package rigibo.frontend.puzzle.hud;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/**
 * Positions of the prizes of a solved level and of their words: side by side with the words below,
 * or one below the other with the words beside.
 *
 * @param x middle of the first, px
 * @param y middle of the first, px
 * @param isAcross whether they lie side by side
 */
record PrizePlaces(double x, double y, boolean isAcross) {

    /** Distance between the middles of two, side by side and one below the other, px. */
    private static final double COLUMN = 148;

    private static final double ROW = 66;

    /**
     * Distance from the middle of a prize to that of its words below, or to the start of those
     * beside.
     */
    private static final double BELOW = 46;

    private static final double BESIDE = 48;

    /** Least distance between the words of two that lie side by side, px. */
    private static final double APART = 8;

    private static final double SIZE = 16;

    /** Distance from the middle of words, or of a prize, to the next part, px. */
    private static final double AFTER_WORDS = 12;

    private static final double AFTER_PRIZE = 32;

    /** {@code count} prizes side by side about a middle, px. */
    static PrizePlaces across(double middle, double y, int count) {
        return new PrizePlaces(middle - (count - 1) / 2.0 * COLUMN, y, true);
    }

    double x(int number) {
        return isAcross ? x + number * COLUMN : x;
    }

    double y(int number) {
        return isAcross ? y : y + number * ROW;
    }

    /** Lower edge of {@code count} prizes, px. */
    double bottom(int count) {
        return y(count - 1) + (isAcross ? BELOW + AFTER_WORDS : AFTER_PRIZE);
    }

    /** Whether words do not touch those of the next prize. */
    boolean hasRoomFor(Canvas canvas, String words) {
        double width = canvas.textWidth(words, SIZE, Canvas.Font.WORDS);
        return !canvas.layout().isInHand() && (!isAcross || width <= COLUMN - APART);
    }

    void drawWords(Canvas canvas, String words, int number, Color ink) {
        double wordsX = x(number) + (isAcross ? 0 : BESIDE);
        double wordsY = y(number) + (isAcross ? BELOW : 0);
        Canvas.Align align = isAcross ? Canvas.Align.CENTRE : Canvas.Align.LEFT;
        canvas.text(words, wordsX, wordsY, SIZE, Canvas.Font.WORDS, align, ink);
    }
}

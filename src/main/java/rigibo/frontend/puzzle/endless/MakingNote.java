package rigibo.frontend.puzzle.endless;

import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Print;

/**
 * Draws a note that a level is being made, with dots that appear one after the other, or that none
 * can be made.
 */
public final class MakingNote {

    private static final int DOTS = 3;
    private static final int DOT_STEPS = Steps.of(0.5);
    private static final double DOT_PITCH = 26;

    /** Distance from the middle of the note to the words about the search, px. */
    private static final double EFFORT = 54;

    private MakingNote() {}

    /**
     * Tells screen readers whether a level is being made, but not the effort, which changes all the
     * time.
     */
    public static void describe(Narrator narrator, Words words, Making making) {
        narrator.says(words.of(making.isHopeless() ? "made.none" : "made.making"));
    }

    /**
     * Draws the note.
     *
     * @param middle of it, px
     * @param y middle of it, px
     * @param steps since it was first shown
     */
    public static void draw(
            Canvas canvas,
            Words words,
            Making making,
            double middle,
            double y,
            int steps,
            Motion motion) {
        double unit = canvas.layout().lettered(1);
        if (making.isHopeless()) {
            Print.centred(canvas, words.of("made.none"), middle, y, 18, Color.TEXT);
            return;
        }
        Print.centred(canvas, words.of("made.making"), middle, y - 16 * unit, 18, Color.TEXT);
        int shown = motion == Motion.REDUCED ? DOTS : steps / DOT_STEPS % (DOTS + 1);
        for (int i = 0; i < shown; i++) {
            canvas.disc(
                    middle + (i - (DOTS - 1) / 2.0) * DOT_PITCH * unit,
                    y + 20 * unit,
                    6 * unit,
                    Color.BRASS);
        }
        making.effort()
                .map(effort -> words.of("made.effort", effort.plans(), effort.games()))
                .ifPresent(
                        told ->
                                Print.centred(
                                        canvas,
                                        told,
                                        middle,
                                        y + EFFORT * unit,
                                        16,
                                        Color.TEXT_DIM));
    }
}

package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Steps;

import java.util.Locale;

/**
 * The outcome of a game that was played to its end.
 *
 * @param end the outcome
 * @param steps number of steps up to the end
 * @param still step at which the last body came to rest; the end itself if some never did
 * @param why the reason in words, if it was not won
 * @param hasStar whether it earned the level's star
 */
record Verdict(End end, int steps, int still, String why, boolean hasStar) {

    /** The ways in which a game may end. */
    enum End {
        WON,
        /** Lost, or undecided for too long. */
        LOST,
        /** All bodies are at rest, and only one more click would help. */
        STUCK,
        /** A click was not allowed. */
        REFUSED
    }

    boolean isWon() {
        return end == End.WON;
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT, "%s at %.2f s", isWon() ? "won" : why, Steps.seconds(steps));
    }
}

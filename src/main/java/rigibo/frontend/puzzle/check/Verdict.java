package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Steps;

import java.util.Locale;

/**
 * How a game that was played to its end went.
 *
 * @param end how
 * @param steps when, in steps
 * @param still when the last thing came to rest, in steps; the end itself where nothing did
 * @param why in words, where it was not won
 */
record Verdict(End end, int steps, int still, String why) {

    /** How a game may end. */
    enum End {
        WON,
        /** Lost, or undecided for too long. */
        LOST,
        /** All rests; only one more click would help. */
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

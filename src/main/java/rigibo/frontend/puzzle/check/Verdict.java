package rigibo.frontend.puzzle.check;

import java.util.Locale;

/**
 * How a game that was played to its end went.
 *
 * @param isWon whether it was won
 * @param seconds when it ended
 * @param why in words, where it was not won
 */
record Verdict(boolean isWon, double seconds, String why) {

    @Override
    public String toString() {
        return String.format(Locale.ROOT, "%s at %.2f s", isWon ? "won" : why, seconds);
    }
}

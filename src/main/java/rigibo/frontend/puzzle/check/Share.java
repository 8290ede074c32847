package rigibo.frontend.puzzle.check;

import java.util.Locale;

/**
 * The share of games that were won.
 *
 * @param wins games won
 * @param games games played: all that exist, or a sample
 * @param isWhole whether they are all that exist
 */
record Share(int wins, int games, boolean isWhole) {

    private static final double PERCENT = 100;

    /** Standard deviations of a normal distribution that hold 95 % of it to both sides. */
    private static final double Z = 1.96;

    /** Share of the games played, 0 to 1; 0 if there are none. */
    double value() {
        return wins / (double) Math.max(1, games);
    }

    /**
     * A bound of the interval that holds the share of all games with 95 % certainty: the lower one
     * for side -1, the upper one for 1.
     *
     * <p>Wilson, Probable Inference, the Law of Succession, and Statistical Inference, 1927: unlike
     * the normal approximation it holds for few wins, and for none.
     */
    private double end(int side) {
        double n = Math.max(1, games);
        double spread = Z * Math.sqrt(value() * (1 - value()) / n + Z * Z / (4 * n * n));
        return (value() + Z * Z / (2 * n) + side * spread) / (1 + Z * Z / n);
    }

    /** Lower bound of the share of all games, 0 to 1; with 95 % certainty for a sample. */
    double least() {
        return isWhole ? value() : end(-1);
    }

    /** Upper bound of the share of all games. */
    double most() {
        return isWhole ? value() : end(1);
    }

    @Override
    public String toString() {
        return isWhole
                ? String.format(Locale.ROOT, "%.0f %%", PERCENT * value())
                : String.format(
                        Locale.ROOT,
                        "%.0f %%, with 95 %% certainty %.1f to %.1f %%",
                        PERCENT * value(),
                        PERCENT * least(),
                        PERCENT * most());
    }
}

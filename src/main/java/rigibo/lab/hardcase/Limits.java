package rigibo.lab.hardcase;

/**
 * The limits of a figure, by preset.
 *
 * @param draft of DRAFT, where the case holds it to limits of its own
 * @param game of GAME
 * @param fine of FINE, as a rule that of GAME
 * @param exact of EXACT
 */
record Limits(double draft, double game, double fine, double exact) {

    /** No limits: the figure is only reported. */
    static final Limits NONE = same(Double.POSITIVE_INFINITY);

    /** Limits for DRAFT, for GAME and FINE, and for EXACT. */
    Limits(double draft, double game, double exact) {
        this(draft, game, game, exact);
    }

    /** One limit for all. */
    static Limits same(double most) {
        return new Limits(most, most, most);
    }

    /** Limits for the presets up to FINE, and for EXACT. */
    static Limits of(double game, double exact) {
        return new Limits(game, game, exact);
    }

    double of(Preset preset) {
        return switch (preset) {
            case DRAFT -> draft;
            case GAME -> game;
            case FINE -> fine;
            case EXACT -> exact;
        };
    }
}

package rigibo.lab.hardcase;

/**
 * What a figure may be at most, by preset.
 *
 * @param draft of DRAFT, where the case holds it to limits of its own
 * @param game of GAME
 * @param fine of FINE, as a rule that of GAME
 * @param exact of EXACT
 */
record Limits(double draft, double game, double fine, double exact) {

    /** A figure that is told and not judged. */
    static final Limits NONE = same(Double.POSITIVE_INFINITY);

    /** FINE is held to the limit of GAME. */
    Limits(double draft, double game, double exact) {
        this(draft, game, game, exact);
    }

    /** One limit for all. */
    static Limits same(double most) {
        return new Limits(most, most, most);
    }

    /** DRAFT is held to the limit of GAME, if to any. */
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

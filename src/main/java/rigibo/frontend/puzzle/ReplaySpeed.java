package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.session.Pace;

/**
 * The speed of a replay, always in whole steps of 1/60 s, so that the run does not depend on it.
 */
enum ReplaySpeed {
    QUARTER(Pace.QUARTER, 1, "¼ ×"),
    HALF(Pace.HALF, 1, "½ ×"),
    FULL(Pace.FULL, 1, "1 ×"),
    DOUBLE(Pace.FULL, 2, "2 ×"),
    FOURFOLD(Pace.FULL, 4, "4 ×");

    private final Pace pace;
    private final int framesPerTurn;
    private final String words;

    ReplaySpeed(Pace pace, int framesPerTurn, String words) {
        this.pace = pace;
        this.framesPerTurn = framesPerTurn;
        this.words = words;
    }

    Pace pace() {
        return pace;
    }

    int framesPerTurn() {
        return framesPerTurn;
    }

    /** Label, the same in every language. */
    String words() {
        return words;
    }

    ReplaySpeed slower() {
        return values()[Math.max(ordinal() - 1, 0)];
    }

    /** The next speed; after the fastest comes the slowest. */
    ReplaySpeed next() {
        return values()[(ordinal() + 1) % values().length];
    }

    ReplaySpeed faster() {
        return values()[Math.min(ordinal() + 1, values().length - 1)];
    }
}

package rigibo.frontend.puzzle.session;

/**
 * The speed of the game, always in whole steps of 1/60 s, so that the outcome does not depend on
 * it.
 */
public enum Pace {
    FULL(1),
    HALF(2),
    QUARTER(4);

    private final int framesPerStep;

    Pace(int framesPerStep) {
        this.framesPerStep = framesPerStep;
    }

    int framesPerStep() {
        return framesPerStep;
    }

    public Pace slower() {
        return values()[Math.min(ordinal() + 1, values().length - 1)];
    }

    public Pace faster() {
        return values()[Math.max(ordinal() - 1, 0)];
    }

    /** The next speed for a button: slower and slower, then full speed again. */
    public Pace next() {
        return values()[(ordinal() + 1) % values().length];
    }
}

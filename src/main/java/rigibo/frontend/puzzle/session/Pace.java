package rigibo.frontend.puzzle.session;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

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

    /** Its name in links. */
    public String linked() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The speed that a link names; empty if there is no such speed. */
    public static Optional<Pace> ofLinked(String name) {
        return Arrays.stream(values()).filter(one -> one.linked().equals(name)).findFirst();
    }

    public Pace slower() {
        return values()[Math.min(ordinal() + 1, values().length - 1)];
    }

    public Pace faster() {
        return values()[Math.max(ordinal() - 1, 0)];
    }

    /** The next speed for a button: ever slower, then full speed again. */
    public Pace next() {
        return values()[(ordinal() + 1) % values().length];
    }
}

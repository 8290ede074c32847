package rigibo.frontend.puzzle.rules;

/** The time that must pass between two clicks. Counts in steps, so that its end is exact. */
final class Cooldown {

    private final int length;
    private int readyAt;

    Cooldown(int steps) {
        length = steps;
    }

    Cooldown copy() {
        Cooldown copy = new Cooldown(length);
        copy.readyAt = readyAt;
        return copy;
    }

    /** Exactly at its end the next click is allowed. */
    boolean isReady(int now) {
        return now >= readyAt;
    }

    void start(int now) {
        readyAt = now + length;
    }

    /** Share of the cooldown that remains: 1 just after a click, 0 when the next is allowed. */
    double left(int now) {
        return isReady(now) ? 0 : (readyAt - now) / (double) length;
    }
}

package rigibo.frontend.scene;

/**
 * Totals of a player over all levels, as far back as games have counted them. Each number stops at
 * the largest int.
 *
 * @param tries tries that ended, or were left after a click
 * @param clicks clicks that did something, including those taken back
 * @param steps steps of 1/60 s played until levels were won or lost
 */
public record Totals(int tries, int clicks, int steps) {

    /** Nothing yet. */
    public static final Totals NONE = new Totals(0, 0, 0);

    public Totals {
        if (tries < 0 || clicks < 0 || steps < 0) {
            throw new IllegalArgumentException(
                    "Totals must be 0 or more, were "
                            + tries
                            + " tries, "
                            + clicks
                            + " clicks, "
                            + steps
                            + " steps");
        }
    }

    /** Adds other totals. */
    public Totals plus(Totals more) {
        return new Totals(sum(tries, more.tries), sum(clicks, more.clicks), sum(steps, more.steps));
    }

    private static int sum(int one, int other) {
        return (int) Math.min(Integer.MAX_VALUE, (long) one + other);
    }

    /** The difference from an earlier state of these totals. */
    public Totals since(Totals before) {
        return new Totals(
                Math.max(0, tries - before.tries),
                Math.max(0, clicks - before.clicks),
                Math.max(0, steps - before.steps));
    }

    /** Time played, s. */
    public double seconds() {
        return steps * Scene.STEP;
    }
}

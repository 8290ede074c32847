package rigibo.lab.engine;

/** The knob that varies along a line of a figure; all others are as in the game. */
public enum Line {
    /** Our four presets. */
    PRESETS("preset", ""),
    /** Other engines at their defaults and at finer settings. */
    PEERS("engine", ""),
    STEP("step", "s"),
    STEP_EULER("step, by Euler", "s"),
    STEP_VERLET("step, by Verlet", "s"),
    STEP_RK4("step, by RK4", "s"),
    STEP_DISCRETE("step, impacts at its end", "s"),
    STEP_SPLIT("step, impacts split", "s"),
    SUBSTEPS("substeps", "a step"),
    ITERATIONS("passes", "a substep"),
    TOLERANCE("impact tolerance", "m"),
    IMPACTS_PER_PAIR("impacts a pair", "a step"),
    SEARCH("search", ""),
    SOLVER("contact solver", ""),
    CORRECTION("correction", "");

    private final String words;
    private final String unit;

    Line(String words, String unit) {
        this.words = words;
        this.unit = unit;
    }

    /** The name of the knob. */
    public String words() {
        return words;
    }

    /** The unit of the values along the line; empty if they are choices rather than numbers. */
    public String unit() {
        return unit;
    }

    /**
     * Whether the values are numbers, so that the points are joined and an order of convergence can
     * be observed.
     */
    public boolean isSwept() {
        return !unit.isEmpty();
    }
}

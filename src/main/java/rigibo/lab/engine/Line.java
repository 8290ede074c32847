package rigibo.lab.engine;

/** What is turned along a line of a figure, everything else being as in the game. */
public enum Line {
    /** Our four. */
    PRESETS("preset", ""),
    /** Other engines, as they come and finer. */
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

    /** What is turned, in words. */
    public String words() {
        return words;
    }

    /** Of the values along the line; empty where they are choices, not numbers. */
    public String unit() {
        return unit;
    }

    /** Whether numbers are swept, so that its points are joined and an order can be observed. */
    public boolean isSwept() {
        return !unit.isEmpty();
    }
}

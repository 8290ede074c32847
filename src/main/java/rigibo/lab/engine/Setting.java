package rigibo.lab.engine;

/**
 * A setting of an engine.
 *
 * @param name as its users would say it; no two of an engine are alike
 * @param line of a figure that it is a point of
 * @param at the value of what is swept along that line, in its unit; 0 where nothing is
 * @param step s from one step to the next
 */
public record Setting(String name, Line line, double at, double step) {

    /** The game's time step, s. */
    public static final double USUAL_STEP = 1.0 / 60;

    /** A setting outside the sweeps, at the game's time step. */
    public static Setting of(String name, Line line) {
        return new Setting(name, line, 0, USUAL_STEP);
    }
}

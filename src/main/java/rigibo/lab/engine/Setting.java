package rigibo.lab.engine;

/**
 * A setting of an engine.
 *
 * @param name in the words of the engine's users; unique within the engine
 * @param line the line of a figure that it is a point of
 * @param at value of the knob that varies along that line, in its unit; 0 if none does
 * @param step time step, s
 */
public record Setting(String name, Line line, double at, double step) {

    /** The game's time step, s. */
    public static final double USUAL_STEP = 1.0 / 60;

    /** A setting outside the sweeps, at the game's time step. */
    public static Setting of(String name, Line line) {
        return new Setting(name, line, 0, USUAL_STEP);
    }
}

package rigibo.lab.problem;

import rigibo.lab.engine.Line;

import java.util.List;

/**
 * A scene whose truth is known, and the error of a run.
 *
 * @param id R1 to R20
 * @param title what happens, in a few words
 * @param error name and unit of its error, as the label of an axis
 * @param equalBelow the error that {@code EXACT} promises; smaller errors count as equal
 * @param lines the knobs that change its error; the presets and other engines are always run
 * @param isLong whether a run takes minutes, so that it is timed only once
 * @param isForAll whether other engines can run it
 * @param setup makes the worlds
 */
public record Problem(
        String id,
        String title,
        String error,
        double equalBelow,
        List<Line> lines,
        boolean isLong,
        boolean isForAll,
        Setup setup) {

    /** Makes a trial of the problem. */
    @FunctionalInterface
    public interface Setup {

        /** Makes the worlds, up to before their first step. */
        Trial set(Bench bench);
    }

    /** A problem of seconds, for every engine. */
    public Problem(
            String id,
            String title,
            String error,
            double equalBelow,
            List<Line> lines,
            Setup setup) {
        this(id, title, error, equalBelow, lines, false, true, setup);
    }

    /** A copy that is marked as taking minutes. */
    Problem ofMinutes() {
        return new Problem(id, title, error, equalBelow, lines, true, isForAll, setup);
    }

    /** A copy that only our engine runs. */
    Problem ofOursAlone() {
        return new Problem(id, title, error, equalBelow, lines, isLong, false, setup);
    }

    /** Makes the worlds, up to before their first step. */
    public Trial set(Bench bench) {
        return setup.set(bench);
    }
}

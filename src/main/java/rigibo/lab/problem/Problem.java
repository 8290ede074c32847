package rigibo.lab.problem;

import rigibo.lab.engine.Line;

import java.util.List;

/**
 * A scene whose truth is known, and how far from it a run ends.
 *
 * @param id R1 to R20
 * @param title what happens, in a few words
 * @param error what its error is, with its unit, as an axis is labelled
 * @param equalBelow the error below which there is nothing to choose: what {@code EXACT} promises;
 *     two that are less count as equal
 * @param lines what can be turned that it answers to; the presets and other engines are always
 *     asked
 * @param isLong whether a run takes minutes, so that it is timed but once
 * @param isForAll whether other engines can be asked, too
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

    /** A copy that only our engine is asked. */
    Problem ofOursAlone() {
        return new Problem(id, title, error, equalBelow, lines, isLong, false, setup);
    }

    /** Makes the worlds, up to before their first step. */
    public Trial set(Bench bench) {
        return setup.set(bench);
    }
}

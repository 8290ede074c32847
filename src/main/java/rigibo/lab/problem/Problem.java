package rigibo.lab.problem;

import rigibo.lab.engine.Line;

import java.util.List;

/** A scene whose truth is known, and how far from it a run ends. */
public interface Problem {

    /** R1 to R20. */
    String id();

    /** What happens, in a few words. */
    String title();

    /** What its error is, with its unit, as an axis is labelled. */
    String error();

    /**
     * The error below which there is nothing to choose: what {@code EXACT} promises. Two that are
     * less count as equal.
     */
    double equalBelow();

    /** What can be turned that it answers to; the presets and other engines are always asked. */
    List<Line> lines();

    /** Whether a run takes minutes, so that it is timed but once. */
    default boolean isLong() {
        return false;
    }

    /** Whether other engines can be asked, too. */
    default boolean isForAll() {
        return true;
    }

    /** Makes the worlds, up to before their first step. */
    Trial set(Bench bench);
}

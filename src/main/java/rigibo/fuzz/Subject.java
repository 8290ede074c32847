package rigibo.fuzz;

import java.util.Optional;

/** What is tried with one random thing after another. */
interface Subject {

    /** What it is called on the command line. */
    String title();

    /** The options by which the command tries the thing again. */
    default String again(long seed, long index) {
        return "--only " + title() + " --seed " + seed + " --first " + index;
    }

    /** Tries the thing with an index among those of a seed: all about what went wrong, if any. */
    Optional<String> tried(long seed, long index);
}

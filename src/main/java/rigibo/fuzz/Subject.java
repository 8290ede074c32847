package rigibo.fuzz;

import java.util.Optional;

/** Something that is tried with one random input after another. */
interface Subject {

    /** The name on the command line. */
    String title();

    /** The options of the command that repeat a try. */
    default String again(long seed, long index) {
        return "--only " + title() + " --seed " + seed + " --first " + index;
    }

    /** Tries the input with an index among those of a seed; returns a report if it fails. */
    Optional<String> tried(long seed, long index);
}

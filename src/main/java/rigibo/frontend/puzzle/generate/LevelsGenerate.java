package rigibo.frontend.puzzle.generate;

import java.io.PrintWriter;
import java.util.Optional;

/** The command {@code levels generate}: prints the levels of seeds, or statistics of them. */
public final class LevelsGenerate {

    private static final int ALL_FOUND = 0;
    private static final int SOME_MISSING = 1;

    private final PrintWriter out;
    private final PrintWriter err;

    /** Prints levels to {@code out} and reports to {@code err}. */
    public LevelsGenerate(PrintWriter out, PrintWriter err) {
        this.out = out;
        this.err = err;
    }

    /**
     * Prints the level of each seed as a file, and its figures.
     *
     * @param first seed
     * @param count of seeds in a row
     * @return 0 when each has a level, else 1
     */
    public int print(long first, int count) {
        Generator generator = new Generator();
        boolean isComplete = true;
        for (long seed = first; seed < first + count; seed++) {
            Optional<Generated> made = generator.level(seed);
            made.ifPresent(level -> out.print(level.text()));
            out.flush();
            err.println(words(seed, made));
            isComplete &= made.isPresent();
        }
        return isComplete ? ALL_FOUND : SOME_MISSING;
    }

    /**
     * Prints a line for the level of each seed; at the end the number of levels, of those alike,
     * and the work of finding them.
     *
     * @return 0 when each has a level, else 1
     */
    public int summary(long first, int count) {
        Generator generator = new Generator();
        Census census = new Census();
        for (long seed = first; seed < first + count; seed++) {
            Optional<Generated> made = generator.level(seed);
            census.add(made);
            out.println(words(seed, made));
            out.flush();
        }
        census.lines().forEach(out::println);
        out.flush();
        return census.isComplete() ? ALL_FOUND : SOME_MISSING;
    }

    private static String words(long seed, Optional<Generated> made) {
        return "seed "
                + seed
                + ": "
                + made.map(level -> level.figures() + "; " + level.effort())
                        .orElse("no plan of this seed is a puzzle");
    }
}

package rigibo.backend.law;

import java.util.List;
import java.util.stream.LongStream;

/**
 * The seeds that a law is asked for: all of them for the table of docs/laws.md, otherwise the first
 * third, but eight at least, so that tests do not take too long.
 *
 * @param all in the order they are asked
 */
record Seeds(List<Long> all) {

    private static final int FEWEST = 8;
    private static final boolean ARE_ALL_ASKED = LawTable.isWanted();

    /** From 1 to the last. */
    static Seeds upTo(long last) {
        return new Seeds(LongStream.rangeClosed(1, last).boxed().toList());
    }

    static Seeds of(Long... seeds) {
        return new Seeds(List.of(seeds));
    }

    /** Those that are asked now. */
    List<Long> asked() {
        int third = Math.max(FEWEST, (all.size() + 2) / 3);
        return ARE_ALL_ASKED ? all : all.subList(0, Math.min(third, all.size()));
    }

    /** All but those that are known to break the law; a disabled test must name them. */
    Seeds without(Seeds known) {
        if (!all.containsAll(known.all)) {
            throw new IllegalArgumentException(known + " would not have run");
        }
        return new Seeds(all.stream().filter(seed -> !known.all.contains(seed)).toList());
    }
}

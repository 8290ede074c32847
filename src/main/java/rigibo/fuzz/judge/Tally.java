package rigibo.fuzz.judge;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;

/** Counts the checks that were really made. */
public final class Tally {

    /** The counters. */
    public enum Of {
        PROGRAMS,
        OPERATIONS,
        STEPS,
        QUERIES,
        COPIES,
        ALTERED_SNAPSHOTS_RESTORED,
        REFUSALS,
        QUARANTINED,
        FILES,
        FILES_REFUSED
    }

    private final Map<Of, Long> counts = new EnumMap<>(Of.class);

    /** Adds one. */
    public void count(Of what) {
        counts.merge(what, 1L, Long::sum);
    }

    /** The value of a counter. */
    public long of(Of what) {
        return counts.getOrDefault(what, 0L);
    }

    /** All counters in one line. */
    @Override
    public String toString() {
        StringBuilder words = new StringBuilder();
        counts.forEach(
                (what, count) ->
                        words.append(words.length() > 0 ? ", " : "")
                                .append(String.format(Locale.ROOT, "%,d ", count))
                                .append(what.name().toLowerCase(Locale.ROOT).replace('_', ' ')));
        return words.toString();
    }
}

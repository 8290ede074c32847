package rigibo.fuzz.judge;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;

/** How much was really asked. */
public final class Tally {

    /** What is counted. */
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

    /** One more. */
    public void count(Of what) {
        counts.merge(what, 1L, Long::sum);
    }

    /** How many. */
    public long of(Of what) {
        return counts.getOrDefault(what, 0L);
    }

    /** All that was counted, in one line. */
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

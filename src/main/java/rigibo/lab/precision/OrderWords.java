package rigibo.lab.precision;

import rigibo.lab.engine.Line;

import java.util.Locale;
import java.util.OptionalInt;

/** States the observed order of convergence, and explains it where it is not the promised one. */
final class OrderWords {

    private OrderWords() {}

    /** A sentence about a line along which the step varies. */
    static String of(Asked asked, Line line) {
        ObservedOrder order = ObservedOrder.of(asked.along(line));
        ObservedOrder.Verdict verdict = order.verdict(line, asked.along(line));
        String number = String.format(Locale.ROOT, "%.1f", order.median());
        return "Along \u201c" + line.words() + "\u201d " + finding(verdict, number, line) + ".";
    }

    private static String finding(ObservedOrder.Verdict verdict, String order, Line line) {
        OptionalInt expected = ObservedOrder.expected(line);
        String promised =
                expected.isPresent() ? ", where its method promises " + expected.getAsInt() : "";
        return switch (verdict) {
            case AS_EXPECTED -> "the order observed is " + order + ", as its method promises";
            case HIGHER ->
                    "the order observed is "
                            + order
                            + promised
                            + ": its leading term cancels over a whole turn or a symmetric path";
            case LOWER ->
                    "the order observed is "
                            + order
                            + promised
                            + ": the errors of the solver or the tolerance have another order";
            case SOME -> "the order observed is " + order;
            case FLAT ->
                    "the error hardly depends on the step: it comes from the tolerance or the"
                            + " solver, which stay the same";
            case RISING ->
                    "the error grows as the step shrinks: more steps add up more rounding and more"
                            + " of what each leaves unsolved";
            case IRREGULAR ->
                    "errors alternately fall and rise: they depend on where in a step an event"
                            + " falls";
            case EXACT -> "only rounding is left at every step";
            case NOT_KNOWN -> "too few errors exceed rounding to give an order";
        };
    }
}

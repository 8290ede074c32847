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
                            + ": its leading term cancels here, over a whole turn or a symmetric"
                            + " way";
            case LOWER ->
                    "the order observed is "
                            + order
                            + promised
                            + ": what else errs, the solver or what the tolerance leaves, is not"
                            + " of that order";
            case SOME -> "the order observed is " + order;
            case FLAT ->
                    "the error hardly answers to the step: what is left comes from the tolerance or"
                            + " the solver, which stay as they are";
            case RISING ->
                    "the error grows as the step shrinks: more steps add up what each rounds or"
                            + " leaves unsolved";
            case IRREGULAR ->
                    "errors fall and rise by turns: they depend on where in a step an event happens"
                            + " to fall";
            case EXACT -> "nothing is left but rounding, whatever the step";
            case NOT_KNOWN -> "too few errors are above rounding to tell an order";
        };
    }
}

package rigibo.lab.precision;

import rigibo.lab.report.Amount;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** Makes the sentences of the report from the measured numbers. */
final class PrecisionSentences {

    /** The problems for which there are aims against other engines. */
    private static final List<String> COMPARED = List.of("R1", "R2", "R5", "R6", "R8", "R10");

    private static final double NANOS_PER_MICRO = 1e3;

    private final List<Asked> all;

    PrecisionSentences(List<Asked> all) {
        this.all = all;
    }

    /** The main sentences. */
    List<String> main() {
        List<String> sentences = new ArrayList<>();
        sentences.add(
                "Each setting's error against a derived truth, beside the processor time it takes,"
                        + " for "
                        + all.size()
                        + " reference problems.");
        List<Asked> atKnobs = all.stream().filter(asked -> !asked.lines().isEmpty()).toList();
        if (!atKnobs.isEmpty()) {
            sentences.add(FrontWords.of(atKnobs));
        }
        List<Comparison> comparisons = comparisons();
        if (!comparisons.isEmpty()) {
            sentences.add(mostAccurate(comparisons));
            sentences.add(noSlower(comparisons));
        }
        return sentences;
    }

    private List<Comparison> comparisons() {
        return all.stream().map(Comparison::of).flatMap(Optional::stream).toList();
    }

    private static String mostAccurate(List<Comparison> comparisons) {
        List<String> less =
                comparisons.stream()
                        .filter(one -> !one.isMostAccurate())
                        .map(PrecisionSentences::notMostAccurate)
                        .toList();
        long most = comparisons.size() - less.size();
        return "GAME is more accurate than every other engine, at default and finer settings, in "
                + most
                + " of "
                + comparisons.size()
                + " problems"
                + (less.isEmpty()
                        ? "."
                        : "; where errors below what EXACT promises count as equal, others are as"
                                + " accurate in "
                                + String.join("; ", less)
                                + ".");
    }

    private static String notMostAccurate(Comparison one) {
        String others =
                one.asAccurate().stream()
                        .map(point -> point.engine() + " " + point.setting().name())
                        .collect(Collectors.joining(", "));
        String failure = one.game().errors().hasFailed() ? ", where GAME failed" : "";
        return one.game().problem() + failure + " (" + others + ")";
    }

    private static String noSlower(List<Comparison> comparisons) {
        List<String> slower =
                comparisons.stream()
                        .filter(one -> !one.isNoSlower())
                        .map(PrecisionSentences::slower)
                        .toList();
        List<String> won =
                comparisons.stream()
                        .filter(one -> one.isMostAccurate() && one.isNoSlower())
                        .map(one -> one.game().problem())
                        .toList();
        String first =
                won.isEmpty()
                        ? "In no problem is it also as fast per step as the fastest engine in Java"
                        : "It is also as fast per step as the fastest engine in Java in "
                                + String.join(", ", won);
        return first
                + " (the aim: "
                + String.join(", ", COMPARED)
                + ")"
                + (slower.isEmpty() ? "." : "; slower in " + String.join(", ", slower) + ".");
    }

    private static String slower(Comparison one) {
        return one.slowdown()
                .map(
                        times ->
                                String.format(
                                        Locale.ROOT,
                                        "%s (%.1f × %s)",
                                        one.game().problem(),
                                        times,
                                        one.fastestJava().orElseThrow().engine()))
                .orElse(one.game().problem());
    }

    /** The sentences about one problem. */
    List<String> of(Asked asked) {
        List<String> sentences = new ArrayList<>();
        sentences.add(presets(asked));
        Comparison.of(asked).ifPresent(one -> sentences.add(others(asked, one)));
        asked.lines().stream()
                .filter(ObservedOrder::isObservedOf)
                .forEach(line -> sentences.add(OrderWords.of(asked, line)));
        return sentences;
    }

    private static String presets(Asked asked) {
        return asked.presets().stream()
                        .map(PrecisionSentences::told)
                        .collect(Collectors.joining(", "))
                + ".";
    }

    private static String told(Point point) {
        String error =
                point.errors().hasFailed()
                        ? "fails (" + point.errors().failure() + ")"
                        : "errs by " + Amount.scientific(point.errors().main());
        return point.setting().name() + " " + error + time(point);
    }

    private static String time(Point point) {
        return point.timing()
                .map(took -> " at " + Amount.time(took.cpu() * NANOS_PER_MICRO) + " a step")
                .orElse("");
    }

    private static String others(Asked asked, Comparison one) {
        return asked.peers().stream()
                        .map(
                                peer ->
                                        peer
                                                + ": "
                                                + asked.of(peer).stream()
                                                        .map(PrecisionSentences::told)
                                                        .collect(Collectors.joining(", ")))
                        .collect(Collectors.joining("; "))
                + ". "
                + (one.isMostAccurate()
                        ? "GAME is more accurate than all of them"
                        : "GAME is not more accurate than all of them")
                + one.slowdown()
                        .map(
                                times ->
                                        String.format(
                                                Locale.ROOT,
                                                ", and its step takes %.2f of the time of the"
                                                        + " fastest in Java.",
                                                times))
                        .orElse(".");
    }
}

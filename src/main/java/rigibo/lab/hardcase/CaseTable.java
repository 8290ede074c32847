package rigibo.lab.hardcase;

import rigibo.lab.child.Work;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** Formats results for a terminal, as CSV, and as a page of Markdown. */
public final class CaseTable {

    private static final String CSV_HEAD =
            "row,case,preset,figure,value,limit,unit,margin,passes,where,"
                    + "steps,pairs,impacts,evaluations,rows";

    private static final String INTRODUCTION =
            """
            # Hard cases

            These scenes are hard to simulate, and their truth is known in closed form or as an \
            invariant. The class of each case in `src/main/java/rigibo/lab/hardcase` derives it. \
            In every run all numbers must be finite, and overlap must stay below 2 %% of a body's \
            width where the case sets no other limit. No energy may be gained in a step or since \
            the start, momentum is kept, and a second run gives the same bits. `EXACT` has limits \
            of its own, the other presets have those of a game. Sleep is off unless the case is \
            about sleep. A case with many variants runs a few of them; with `--full`, all.

            At `DRAFT` these cases are held to the invariants alone: %s.

            Each line shows the figure nearest to its limit, among all figures of the case that have \
            one. The margin is the limit divided by the figure: below 1 the case fails, and ∞ means \
            that the figure is 0.

            Made by `./rigibo cases%s --markdown FILE` on %s, %s. %d passed, %d failed.

            | row | case | preset | worst figure | value | limit | margin | |
            |---|---|---|---|---:|---:|---:|---|
            """;

    private CaseTable() {}

    /** One line: the verdict, the figure nearest to its limit, and the work of the run. */
    public static String line(HardCase.Result result) {
        Measure worst = result.worst();
        return String.format(
                Locale.ROOT,
                "%-4s %-19s %-5s %-34s %10s of %-9s %-8s x %-9s %s",
                verdict(result),
                result.hardCase().row(),
                result.preset(),
                worst.name(),
                number(worst.figure()),
                number(worst.limit()),
                worst.unit(),
                number(worst.margin()),
                result.work());
    }

    /** A line for every figure beyond its limit, with the place; empty if there is none. */
    public static List<String> failures(HardCase.Result result) {
        return result.measures().stream()
                .filter(measure -> !measure.passes())
                .map(measure -> "       " + measure)
                .toList();
    }

    /** A line for every figure. */
    public static List<String> figures(HardCase.Result result) {
        return result.measures().stream().map(measure -> "       " + measure).toList();
    }

    /** A head and a line for every figure of every result. */
    public static List<String> csv(List<HardCase.Result> results) {
        List<String> lines =
                results.stream()
                        .flatMap(
                                result ->
                                        result.measures().stream()
                                                .map(measure -> csv(result, measure)))
                        .collect(Collectors.toList());
        lines.add(0, CSV_HEAD);
        return lines;
    }

    private static String csv(HardCase.Result result, Measure measure) {
        Work work = result.work().all();
        return List.of(
                        result.hardCase().row(),
                        quoted(result.hardCase().title()),
                        result.preset(),
                        quoted(measure.name()),
                        measure.figure(),
                        measure.limit(),
                        measure.unit(),
                        measure.margin(),
                        measure.passes(),
                        quoted(measure.where()),
                        result.work().steps(),
                        work.pairs(),
                        work.impacts(),
                        work.evaluations(),
                        work.rows())
                .stream()
                .map(String::valueOf)
                .collect(Collectors.joining(","));
    }

    private static String quoted(String words) {
        return '"' + words.replace("\"", "\"\"") + '"';
    }

    /**
     * A page with one line per result.
     *
     * @param options of the command that made it, each after a space
     * @param machine what it ran on
     * @param date when
     */
    public static String page(
            List<HardCase.Result> results, String options, String machine, String date) {
        long passed = results.stream().filter(HardCase.Result::passes).count();
        String head =
                String.format(
                        Locale.ROOT,
                        INTRODUCTION,
                        reportedAtDraft(results),
                        options,
                        machine,
                        date,
                        passed,
                        results.size() - passed);
        return head
                + results.stream().map(CaseTable::pageLine).collect(Collectors.joining("\n"))
                + "\n"
                + findings(results);
    }

    private static String reportedAtDraft(List<HardCase.Result> results) {
        return results.stream()
                .map(HardCase.Result::hardCase)
                .filter(hardCase -> hardCase.limitedFrom() != Preset.DRAFT)
                .filter(hardCase -> hardCase.fastest() == Preset.DRAFT)
                .map(HardCase::row)
                .distinct()
                .collect(Collectors.joining(", "));
    }

    /** Every figure beyond its limit, and why the case fails. */
    private static String findings(List<HardCase.Result> results) {
        List<HardCase.Result> failed = results.stream().filter(result -> !result.passes()).toList();
        StringBuilder words =
                new StringBuilder(failed.isEmpty() ? "" : "\n## What fails, and why\n");
        HardCase told = null;
        for (HardCase.Result result : failed) {
            if (result.hardCase() != told) {
                told = result.hardCase();
                words.append(String.format("%n**%s**, %s. ", told.row(), told.title()));
                words.append(told.finding()).append("\n\n");
            }
            for (Measure measure : result.measures()) {
                if (!measure.passes()) {
                    words.append(
                            String.format(
                                    Locale.ROOT,
                                    "- %s: %s %s %s, at most %s (%s)%n",
                                    result.preset(),
                                    measure.name(),
                                    number(measure.figure()),
                                    measure.unit(),
                                    number(measure.limit()),
                                    measure.where()));
                }
            }
        }
        return words.toString();
    }

    private static String pageLine(HardCase.Result result) {
        Measure worst = result.worst();
        return String.format(
                Locale.ROOT,
                "| %s | %s | %s | %s | %s %s | %s | %s | %s |",
                result.hardCase().row(),
                result.hardCase().title(),
                result.preset(),
                worst.name(),
                number(worst.figure()),
                worst.unit(),
                number(worst.limit()),
                number(worst.margin()),
                result.passes() ? "" : "**fails**");
    }

    private static String verdict(HardCase.Result result) {
        return result.passes() ? "ok" : "FAIL";
    }

    /** A number with three digits; an infinite margin is ∞. */
    private static String number(double value) {
        if (Double.isInfinite(value)) {
            return "∞";
        }
        boolean isWhole = value == Math.rint(value) && Math.abs(value) < 1e4;
        return isWhole ? Long.toString((long) value) : String.format(Locale.ROOT, "%.3g", value);
    }
}

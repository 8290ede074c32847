package rigibo.docs.site;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a setting of an engine was measured to do with a problem.
 *
 * @param engine its name; empty for ours
 * @param setting name of the preset, or how finely another engine was asked
 * @param error relative or in the problem's unit; NaN where the engine failed
 * @param seconds of a step
 */
record Reading(String engine, String setting, double error, double seconds) {

    private static final Pattern FOUND =
            Pattern.compile(
                    "((?:\\d+ )?\\w+) (?:errs by ([\\d.]+(?: × 10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?)|fails"
                            + " \\([^)]*\\)) at ([\\d.]+) (ns|µs|ms|s) a step");

    private static final Pattern ENGINE = Pattern.compile("^- ([^:]+): |; ([^:;]+): ");

    private static final Map<String, Double> UNITS =
            Map.of("ns", 1e-9, "µs", 1e-6, "ms", 1e-3, "s", 1.0);

    /** All that the sentences of a page's section tell. */
    static List<Reading> in(String section) {
        List<Reading> all = new ArrayList<>();
        section.lines().filter(line -> line.startsWith("- ")).forEach(line -> read(line, all));
        return all;
    }

    private static void read(String line, List<Reading> all) {
        Matcher names = ENGINE.matcher(line);
        String engine = "";
        int from = 0;
        while (names.find()) {
            read(engine, line.substring(from, names.start()), all);
            engine = names.group(1) == null ? names.group(2) : names.group(1);
            from = names.end();
        }
        read(engine, line.substring(from), all);
    }

    private static void read(String engine, String words, List<Reading> all) {
        for (MatchResult found : FOUND.matcher(words).results().toList()) {
            double seconds = Double.parseDouble(found.group(3)) * UNITS.get(found.group(4));
            all.add(new Reading(engine, found.group(1), number(found.group(2)), seconds));
        }
    }

    /** A number such as 1.2 × 10⁻³. */
    private static double number(String words) {
        return words == null
                ? Double.NaN
                : Double.parseDouble(
                        Normalizer.normalize(words.replace(" × 10", "e"), Normalizer.Form.NFKC)
                                .replace('−', '-'));
    }

    boolean isOurs() {
        return engine.isEmpty();
    }

    boolean failed() {
        return Double.isNaN(error);
    }
}

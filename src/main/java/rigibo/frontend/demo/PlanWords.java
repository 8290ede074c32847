package rigibo.frontend.demo;

import rigibo.frontend.scene.Words;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Says the plan of a step, which the engine writes in English, in the player's language. */
final class PlanWords {

    /** A stage, or the word "columns", and what it does. */
    private static final Pattern LINE = Pattern.compile("(\\w+) +(.*)");

    private static final Pattern ISLANDS =
            Pattern.compile("solve islands in (\\d+) substeps: (.*)");
    private static final Pattern COLUMNS = Pattern.compile("(.*): (\\d+) bits a body");

    private final Words words;

    PlanWords(Words words) {
        this.words = words;
    }

    /** The lines of a plan; what begins in the engine's plan at the eleventh letter does here. */
    String of(String plan) {
        return plan.lines().map(this::line).collect(Collectors.joining("\n"));
    }

    private String line(String line) {
        Matcher parts = LINE.matcher(line);
        if (!parts.matches()) {
            throw new IllegalArgumentException("no line of a plan: " + line);
        }
        String stage = parts.group(1).toLowerCase(Locale.ROOT);
        return String.format("%-10s %s", words.of("plan.stage." + stage), work(parts.group(2)));
    }

    private String work(String work) {
        Matcher islands = ISLANDS.matcher(work);
        Matcher columns = COLUMNS.matcher(work);
        if (islands.matches()) {
            return words.of("plan.islands", islands.group(1), list(islands.group(2)));
        }
        return columns.matches()
                ? words.of("plan.bits", list(columns.group(1)), columns.group(2))
                : word(work);
    }

    private String list(String all) {
        return Stream.of(all.split(", ")).map(this::word).collect(Collectors.joining(", "));
    }

    private String word(String english) {
        return words.of("plan." + english.toLowerCase(Locale.ROOT).replaceAll("[ ,]+", "-"));
    }
}

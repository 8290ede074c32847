package rigibo.lab.precision;

import rigibo.lab.engine.Line;
import rigibo.lab.engine.Setting;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** States which presets lie on the front, and how much too expensive the others are. */
final class FrontWords {

    private FrontWords() {}

    /** A sentence about the presets of problems, without those that failed or were not timed. */
    static String of(List<Asked> all) {
        long judged = all.stream().mapToLong(asked -> judged(asked).size()).sum();
        long far = all.stream().mapToLong(asked -> far(asked).size()).sum();
        String first =
                String.format(
                        Locale.ROOT,
                        "%d of %d presets lie on the front of our own knobs at the game's step or,"
                                + " by median times, within 10 %% of it",
                        judged - far,
                        judged);
        String rest =
                all.stream()
                        .filter(asked -> !far(asked).isEmpty())
                        .map(asked -> "at " + asked.problem().id() + " " + excesses(asked))
                        .collect(Collectors.joining("; "));
        return rest.isEmpty()
                ? first + "."
                : first
                        + "; the others cost more than a setting that is at least as accurate: "
                        + rest
                        + ".";
    }

    private static List<Point> judged(Asked asked) {
        return asked.presets().stream().filter(Front::isEligible).toList();
    }

    private static List<Point> far(Asked asked) {
        return judged(asked).stream().filter(preset -> !asked.front().isNear(preset)).toList();
    }

    /** Groups presets that the same cheaper setting shows to be too expensive. */
    private static String excesses(Asked asked) {
        Map<String, List<Point>> byCheaper =
                far(asked).stream()
                        .collect(
                                Collectors.groupingBy(
                                        preset -> cheaper(asked, preset),
                                        LinkedHashMap::new,
                                        Collectors.toList()));
        return byCheaper.entrySet().stream()
                .map(one -> excesses(asked, one.getValue()) + " as much as " + one.getKey())
                .collect(Collectors.joining(", "));
    }

    private static String excesses(Asked asked, List<Point> presets) {
        return presets.stream()
                .map(
                        preset ->
                                String.format(
                                        Locale.ROOT,
                                        "%s %.2f ×",
                                        preset.setting().name(),
                                        asked.front().excess(preset)))
                .collect(Collectors.joining(", "));
    }

    private static String cheaper(Asked asked, Point preset) {
        Setting cheapest = asked.front().cheapestAsAccurateAs(preset).orElseThrow().setting();
        String name = cheapest.name();
        return cheapest.line() == Line.PRESETS ? name : "\u201c" + name + "\u201d";
    }
}

package rigibo.frontend.puzzle.generate;

import rigibo.frontend.puzzle.check.Figures;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.ToLongFunction;
import java.util.stream.Collectors;

/** Statistics of the levels of many seeds. */
final class Census {

    private final List<Generated> levels = new ArrayList<>();
    private final Map<Figures, Integer> byFigures = new HashMap<>();
    private final Map<Integer, Integer> byPar = new TreeMap<>();
    private int seeds;

    /** Counts the level of one more seed. */
    void add(Optional<Generated> made) {
        seeds++;
        made.ifPresent(this::add);
    }

    private void add(Generated level) {
        levels.add(level);
        byFigures.merge(level.figures(), 1, Integer::sum);
        byPar.merge(level.figures().par(), 1, Integer::sum);
    }

    boolean isComplete() {
        return levels.size() == seeds;
    }

    /** Number of levels that share their figures with another one. */
    int alike() {
        return byFigures.values().stream()
                .filter(count -> count > 1)
                .mapToInt(Integer::intValue)
                .sum();
    }

    List<String> lines() {
        String pars =
                byPar.entrySet().stream()
                        .map(each -> each.getValue() + " of par " + each.getKey())
                        .collect(Collectors.joining(", "));
        return List.of(
                levels.size()
                        + " of "
                        + seeds
                        + " seeds have a level; "
                        + alike()
                        + " of these are alike by their figures",
                pars.isEmpty() ? "none of any par" : pars,
                work("plans", level -> level.effort().plans()),
                work("games", level -> level.effort().games()),
                work("steps", level -> level.effort().steps()));
    }

    /** The median and the largest of a figure. */
    private String work(String what, ToLongFunction<Generated> figure) {
        long[] sorted = levels.stream().mapToLong(figure).sorted().toArray();
        return sorted.length == 0
                ? "no " + what
                : String.format(
                        Locale.ROOT,
                        "%s for a level: half of them at most %,d, all at most %,d",
                        what,
                        sorted[(sorted.length - 1) / 2],
                        sorted[sorted.length - 1]);
    }
}

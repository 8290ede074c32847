package rigibo.frontend.puzzle.check;

import rigibo.frontend.document.Fault;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Star;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.LongConsumer;
import java.util.stream.Collectors;

/**
 * Checks that need a game to be played. E151: a stored solution does not win, as stated or with
 * small variations; E152: fewer clicks than par win; E154: the star is not earned, or is no secret;
 * E160: the level moves by itself.
 */
final class LevelCheck {

    private final LoadedLevel loaded;
    private final Level level;
    private final List<Preset> presets;
    private final OptionalInt place;
    private final List<String> proved = new ArrayList<>();
    private final Games games;

    private LevelCheck(
            LoadedLevel loaded,
            Level level,
            List<Preset> presets,
            OptionalInt place,
            LongConsumer told) {
        this.loaded = loaded;
        this.level = level;
        this.presets = presets;
        this.place = place;
        games = new Games(Games.Cores.ALL, told);
    }

    /**
     * Plays a level without loading errors; adds its errors to its problems.
     *
     * @param place of the level in its world, from 1; empty for a level that is not of the game
     * @param told receives the number of games after each, on any thread
     * @return a report of what was played, a line each
     */
    static List<String> play(
            LoadedLevel loaded,
            Level level,
            List<Preset> presets,
            OptionalInt place,
            LongConsumer told) {
        LevelCheck check = new LevelCheck(loaded, level, presets, place, told);
        check.play();
        return check.proved;
    }

    private void play() {
        RestCheck.check(loaded, level, presets);
        for (int i = 0; i < level.solutions().size(); i++) {
            solution("/solutions/" + i, level.solutions().get(i));
        }
        level.star().ifPresent(this::star);
        if (level.limits().par() > 1) {
            singleClicks();
        }
        orders();
    }

    private void solution(String pointer, Solution solution) {
        SolutionTrials trials = SolutionTrials.of(level, solution, presets, games);
        int count = trials.games().size();
        String clicks =
                solution.clicks().stream()
                        .map(click -> click.target() + " at " + click.seconds() + " s")
                        .collect(Collectors.joining(", "));
        proved.add(clicks + ": wins " + trials.wins() + " of " + count + " games");
        trials.firstLost()
                .ifPresent(
                        lost ->
                                loaded.error(
                                        pointer,
                                        Fault.of(
                                                trials.wins() == 0 ? "E151.never" : "E151",
                                                "E151 wins only %s of %s games with everything up"
                                                        + " to 10 mm aside and clicks up to 0.25 s"
                                                        + " late; lost %s",
                                                trials.wins(),
                                                count,
                                                lost)));
        NeededClicks.winner(level, solution, presets, games)
                .ifPresent(
                        words ->
                                loaded.error(
                                        pointer,
                                        Fault.of(
                                                "E152.more",
                                                "E152 has a click too many: %s",
                                                words)));
    }

    private void star(Star star) {
        StarTrials trials = new StarTrials(level, star, presets, games);
        proved.add("secret star: " + trials.words());
        trials.fault().ifPresent(fault -> loaded.error("/star", fault));
    }

    private void singleClicks() {
        Optional<String> winner = new SingleClicks(level, presets, games).winner();
        winner.ifPresentOrElse(
                words -> loaded.error("/rules/par", parIsTooLarge("E152.single", words)),
                () -> proved.add("no single click wins"));
    }

    /**
     * Searches orders at the game's own accuracy, since they are counted to tell skill from luck,
     * not as a proof.
     */
    private void orders() {
        OrderSearch.Found found = new OrderSearch(level, games).search();
        found.shorter()
                .ifPresentOrElse(
                        clicks ->
                                loaded.error(
                                        "/rules/par",
                                        parIsTooLarge("E152.order", words(clicks) + " wins")),
                        () -> {
                            proved.add(fewer(found.fewer()));
                            proved.add(share(found.wins()));
                            misleading(found);
                        });
    }

    private void misleading(OrderSearch.Found found) {
        FalseLeads leads = new FalseLeads(level, games, FalseLeads.Losses.AND_DEAD_ENDS);
        List<String> first = leads.first(found.winning());
        List<String> forgotten =
                level.solutions().stream()
                        .limit(1)
                        .flatMap(one -> leads.forgotten(one).stream())
                        .toList();
        tell("first clicks that mislead", first);
        tell("the rest misleads without", forgotten);
        boolean isFound = !first.isEmpty() || !forgotten.isEmpty();
        Optional<List<Act>> order = isFound ? Optional.empty() : leads.order(found.lost());
        order.ifPresent(clicks -> proved.add("an order that misleads: " + words(clicks)));
        proved.addAll(Bounds.told(place, level, found.wins(), isFound || order.isPresent()));
    }

    private void tell(String what, List<String> ids) {
        proved.add(what + ": " + ids.size() + (ids.isEmpty() ? "" : " " + String.join(", ", ids)));
    }

    private Fault parIsTooLarge(String kind, String words) {
        return Fault.of(kind, "E152 par is %s, but %s", level.limits().par(), words);
    }

    private static String words(List<Act> clicks) {
        return clicks.stream()
                .map(click -> "\"" + click.target() + "\" at step " + click.step())
                .collect(Collectors.joining(", "));
    }

    private static String fewer(Share fewer) {
        return fewer.isWhole()
                ? "none of all " + fewer.games() + " games of fewer clicks wins"
                : "none of a sample of " + fewer.games() + " games of fewer clicks wins";
    }

    private String share(Share wins) {
        return String.format(
                Locale.ROOT,
                "%d of %s%d orders and times of %d clicks win (%s)",
                wins.wins(),
                wins.isWhole() ? "all " : "a sample of ",
                wins.games(),
                level.limits().par(),
                wins);
    }
}

package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Clickable;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Replay;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Clicks each target alone, on each preset asked for, as the file states the level and with small
 * displacements. The moment of the click is always the same, since E160 proves that the level rests
 * until the first click.
 */
final class SingleClicks {

    /** Varied games per target and preset; they differ from the stated one by chance only. */
    private static final int SEEDS = 4;

    private static final int MOMENT = Steps.of(1);

    private final Level level;
    private final List<Preset> presets;
    private final Games games;

    SingleClicks(Level level, List<Preset> presets, Games games) {
        this.level = level;
        this.presets = presets;
        this.games = games;
    }

    /** Describes the first single click that wins. */
    Optional<String> winner() {
        return games.each(level.clickables().stream().flatMap(this::clicks).toList())
                .filter(click -> games.play(click.level, click.replay).isWon())
                .findFirst()
                .map(Click::words);
    }

    /** One click in one game. */
    private record Click(Level level, Replay replay, Preset preset, int seed) {

        String words() {
            return "one click on \""
                    + replay.acts().get(0).target()
                    + "\" wins at "
                    + preset
                    + (seed == Jitter.STATED ? "" : " with seed " + seed);
        }
    }

    private Stream<Click> clicks(Clickable target) {
        return IntStream.rangeClosed(Jitter.STATED, SEEDS)
                .boxed()
                .flatMap(seed -> presets.stream().map(preset -> click(target.id(), preset, seed)));
    }

    private Click click(String target, Preset preset, int seed) {
        Level moved = Jitter.of(level, seed);
        List<Act> click = List.of(new Act(MOMENT, target));
        return new Click(moved, new Replay(moved.hash(), click, preset.accuracy()), preset, seed);
    }
}

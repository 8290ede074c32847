package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Deletion;
import rigibo.frontend.puzzle.rules.Replay;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Deletes every deletable body alone, on each preset asked for, as the file states it and with
 * small displacements. The moment of the click is always the same, since E160 proves that the level
 * rests until the first click.
 */
final class SingleClicks {

    /** Varied games per body and preset; they differ from the stated one only by luck. */
    private static final int SEEDS = 4;

    private static final int MOMENT = Steps.of(1);

    private final Level level;
    private final List<Preset> presets;

    SingleClicks(Level level, List<Preset> presets) {
        this.level = level;
        this.presets = presets;
    }

    /** Describes the first single click that wins. */
    Optional<String> winner() {
        return bodies().flatMap(this::clicks).toList().parallelStream()
                .filter(click -> Trial.play(click.level, click.replay).isWon())
                .findFirst()
                .map(Click::words);
    }

    /** One click in one game. */
    private record Click(Level level, Replay replay, Preset preset, int seed) {

        String words() {
            return "one click on \""
                    + replay.deletions().get(0).body()
                    + "\" wins at "
                    + preset
                    + (seed == Jitter.STATED ? "" : " with seed " + seed);
        }
    }

    private Stream<LevelBody> bodies() {
        return level.bodies().stream().filter(LevelBody::deletable);
    }

    private Stream<Click> clicks(LevelBody body) {
        return IntStream.rangeClosed(Jitter.STATED, SEEDS)
                .boxed()
                .flatMap(seed -> presets.stream().map(preset -> click(body.id(), preset, seed)));
    }

    private Click click(String body, Preset preset, int seed) {
        Level moved = Jitter.of(level, seed);
        List<Deletion> click = List.of(new Deletion(MOMENT, body));
        return new Click(moved, new Replay(moved.hash(), click, preset.accuracy()), preset, seed);
    }
}

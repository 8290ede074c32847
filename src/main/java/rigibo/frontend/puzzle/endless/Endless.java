package rigibo.frontend.puzzle.endless;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Wording;
import rigibo.frontend.puzzle.record.Ledger;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;

/**
 * Levels one after the other, by their numbers; the next one is prepared while one is played.
 *
 * @param number seed of the next level, from 1
 */
public record Endless(int number) implements Occasion {

    /** Numbers tried until one has a level; nearly all have one. */
    private static final int TRIED = 100;

    @Override
    public List<Long> seeds() {
        return LongStream.range(number, number + TRIED).boxed().toList();
    }

    @Override
    public String title(Words words) {
        return words.of("scene.endless");
    }

    @Override
    public String resultsTitle(Director director) {
        return director.words().of("made.endless.results", number);
    }

    @Override
    public List<List<String>> results(Director director) {
        return List.of();
    }

    /** A number may have no level; then the first later number that has one is played. */
    @Override
    public Occasion of(Making.Made made) {
        return new Endless(Math.toIntExact(made.seed()));
    }

    @Override
    public Level named(Level level, Words words) {
        String title = words.of("made.endless", number);
        return level.called(level.id(), new Wording(Map.of("en", title)));
    }

    @Override
    public Ledger ledger(Director director, Level level) {
        return new MadeLedger(level, game -> following().reached(director));
    }

    @Override
    public Optional<Occasion> next() {
        return Optional.of(following());
    }

    private Endless following() {
        return new Endless(number + 1);
    }

    @Override
    public void reached(Director director) {
        director.progress(director.progress().endless(number));
    }
}

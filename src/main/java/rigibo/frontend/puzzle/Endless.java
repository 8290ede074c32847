package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Wording;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.LongStream;

/**
 * One level after the other, by their numbers; the next one is prepared while one is played.
 *
 * @param number seed of the next level, from 1
 */
record Endless(int number) implements Occasion {

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

    @Override
    public Scene play(Director director, Making.Made made) {
        int seed = Math.toIntExact(made.seed());
        String title = director.words().of("made.endless", seed);
        Level level = made.level().called(made.level().id(), new Wording(Map.of("en", title)));
        // A number may have no level; what is played is the first after it that has one.
        Endless played = new Endless(seed);
        Sequel sequel = new Preparing(director, played.next());
        return new PuzzleScene(director, level, played.ledger(director, level), sequel);
    }

    @Override
    public Ledger ledger(Director director, Level level) {
        return new MadeLedger(level, game -> next().keep(director));
    }

    private Endless next() {
        return new Endless(number + 1);
    }

    private void keep(Director director) {
        director.progress(director.progress().endless(number));
    }

    @Override
    public boolean hasOther() {
        return true;
    }

    @Override
    public Scene other(Director director) {
        next().keep(director);
        return new MadeLevelScene(director, next());
    }

    /** The next level, which is prepared while another one is played. */
    private static final class Preparing implements Sequel {

        private final Director director;
        private final Endless next;
        private final Making making;
        private boolean isHandedOver;

        Preparing(Director director, Endless next) {
            this.director = director;
            this.next = next;
            making = Making.begin(next.seeds());
        }

        /** The level, or what shows that it is still being made. */
        @Override
        public Optional<Supplier<Scene>> next() {
            return Optional.of(this::scene);
        }

        private Scene scene() {
            return making.made().map(made -> next.play(director, made)).orElseGet(this::waiting);
        }

        private Scene waiting() {
            isHandedOver = true;
            return new MadeLevelScene(director, next, making);
        }

        @Override
        public void close() {
            if (!isHandedOver) {
                making.stop();
            }
        }
    }
}

package rigibo.fuzz.file;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.rules.PuzzleGame;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Reads a level and plays it for a moment if it is valid. */
final class LevelReader implements Reader {

    private static final int STEPS = 5;

    /** The most bodies of a level that is stepped here, since the tries are about reading. */
    private static final int MOST_BODIES = 200;

    private final LevelLoader loader = new LevelLoader();

    @Override
    public String title() {
        return "level";
    }

    @Override
    public List<Sample> samples(Path folder) throws IOException {
        List<Sample> samples = new ArrayList<>();
        for (Path file : LevelShelf.files()) {
            samples.add(new Sample("level.json", Files.readAllBytes(file)));
        }
        return samples;
    }

    @Override
    public String read(Path file) {
        LoadedLevel loaded = loader.load(file);
        loaded.level().ifPresent(LevelReader::play);
        return loaded.hasErrors()
                ? loaded.problems().stream().map(Object::toString).collect(Collectors.joining("\n"))
                : "";
    }

    private static void play(Level level) {
        level.hash();
        if (level.bodies().size() <= MOST_BODIES) {
            PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);
            for (int i = 0; i < STEPS; i++) {
                game.step();
            }
        }
    }
}

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

/** A level, which is played for a moment where it is sound. */
final class LevelReader implements Reader {

    private static final int STEPS = 5;

    /** Bodies of a level that may be stepped here; time is the readers'. */
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

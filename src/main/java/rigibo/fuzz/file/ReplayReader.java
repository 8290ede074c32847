package rigibo.fuzz.file;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.Replays;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.replay.LoadedReplay;
import rigibo.frontend.puzzle.replay.Proof;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.ReplayShelf;
import rigibo.frontend.puzzle.rules.Playback;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;

/** Reads a replay and watches it for a moment if it is valid. */
final class ReplayReader implements Reader {

    private static final int STEPS = 5;

    /** A time longer than any stored solution takes. */
    private static final int MOST_STEPS = 6000;

    private final Replays replays = Replays.ofGame();

    @Override
    public String title() {
        return "replay";
    }

    @Override
    public List<Sample> samples(Path folder) throws IOException {
        Level level = new LevelLoader().load(LevelShelf.files().get(0)).level().orElseThrow();
        Recording run = Recording.of(level, level.solutions().get(0), Accuracy.DRAFT, MOST_STEPS);
        ReplayShelf shelf = new ReplayShelf(folder, level);
        shelf.keep(run);
        return List.of(new Sample("some" + ReplayShelf.ENDING, Files.readAllBytes(shelf.best())));
    }

    @Override
    public String read(Path file) {
        LoadedReplay loaded = replays.load(file);
        loaded.recording().ifPresent(ReplayReader::watch);
        return loaded.recording().isPresent()
                ? ""
                : loaded.problems().stream()
                        .map(Object::toString)
                        .collect(Collectors.joining("\n"));
    }

    private static void watch(Recording recording) {
        Playback playback = new Playback(recording.level(), recording.replay());
        Proof proof = new Proof(recording);
        proof.observe(playback);
        for (int i = 0; i < STEPS && proof.verdict().isEmpty(); i++) {
            playback.step();
            proof.observe(playback);
        }
    }
}

package rigibo.frontend.puzzle;

import rigibo.frontend.document.FileText;
import rigibo.frontend.document.Pack;
import rigibo.frontend.document.Problem;
import rigibo.frontend.document.Problems;
import rigibo.frontend.document.ShareCode;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.replay.LoadedReplay;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.ReplayLoader;
import rigibo.frontend.puzzle.replay.ReplayShelf;
import rigibo.frontend.puzzle.replay.UnmadeReplay;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/** Files or a code given by the player: levels to play, or a replay to watch. */
public final class PlayerFiles {

    private final List<Level> levels = new ArrayList<>();
    private final List<Problem> errors = new ArrayList<>();
    private Optional<Recording> recording = Optional.empty();
    private Optional<UnmadeReplay> unmade = Optional.empty();

    private PlayerFiles() {}

    /**
     * Reads files, folders and zip files. A replay may come with its level; of several replays one
     * is shown.
     */
    public static PlayerFiles read(List<Path> given) {
        PlayerFiles read = new PlayerFiles();
        List<Pack.Entry> texts = new ArrayList<>();
        given.forEach(place -> texts.addAll(read.texts(place)));
        LevelLoader loader = new LevelLoader();
        texts.stream()
                .filter(file -> !isReplay(file))
                .map(file -> loader.parse(file.name(), file.text()))
                .forEach(read::add);
        List<Pack.Entry> replays = texts.stream().filter(PlayerFiles::isReplay).toList();
        if (!replays.isEmpty()) {
            read.addReplays(replays);
        }
        return read;
    }

    private List<Pack.Entry> texts(Path place) {
        if (Pack.is(place)) {
            return Pack.read(place, errors);
        }
        Problems problems = new Problems(place.toString());
        Optional<String> text = FileText.read(place, problems);
        errors.addAll(problems.inOrder());
        return text.map(one -> new Pack.Entry(place.toString(), one)).stream().toList();
    }

    /** Reads a code. */
    private static PlayerFiles read(String code) {
        PlayerFiles read = new PlayerFiles();
        Problems problems = new Problems(ShareCode.NAME);
        ShareCode.read(code, problems).ifPresent(read::add);
        read.errors.addAll(problems.inOrder());
        return read;
    }

    private void add(ShareCode code) {
        switch (code.kind()) {
            case LEVEL -> add(new LevelLoader().parse(ShareCode.NAME, code.text()));
            case REPLAY -> add(ShareCode.NAME, code.text(), new ReplayLoader(Levels.all()));
        }
    }

    /** The scene of a pasted code, or one that shows its errors; nothing if it is no code. */
    public static Optional<Scene> pasted(Director director, String text) {
        return Optional.of(text)
                .filter(ShareCode::isMeantBy)
                .map(code -> read(code).scene(director));
    }

    private static boolean isReplay(Pack.Entry file) {
        return file.name().endsWith(ReplayShelf.ENDING);
    }

    private void add(LoadedLevel loaded) {
        loaded.level().ifPresent(levels::add);
        loaded.problems().stream().filter(Problem::isError).forEach(errors::add);
    }

    private void addReplays(List<Pack.Entry> files) {
        List<Level> known = Stream.concat(levels.stream(), Levels.all().stream()).toList();
        ReplayLoader loader = new ReplayLoader(known);
        files.forEach(file -> add(file.name(), file.text(), loader));
    }

    private void add(String name, String text, ReplayLoader loader) {
        LoadedReplay loaded = loader.parse(name, text);
        if (loaded.lacksItsLevelAlone()) {
            unmade = loaded.unmade().map(origin -> new UnmadeReplay(name, text, origin));
        } else {
            errors.addAll(loaded.problems());
        }
        recording = recording.or(loaded::recording);
    }

    /**
     * The scene for the files.
     *
     * @throws IllegalArgumentException with all errors of the files, a line each
     */
    public Function<Director, Scene> sound() {
        if (!errors.isEmpty()) {
            throw new IllegalArgumentException(Levels.words(errors));
        }
        return this::scene;
    }

    /**
     * A film of the replay, or of a solution of the first level.
     *
     * @throws IllegalArgumentException with all errors of the files, or if the level has no
     *     solution or has to be made first
     */
    public Function<Director, Scene> film() {
        sound();
        if (recording.isEmpty() && unmade.isPresent()) {
            String name = unmade.get().name();
            throw new IllegalArgumentException(name + ": its level has to be made first");
        }
        return recording.map(Films::of).orElseGet(() -> Films.of(levels.get(0)));
    }

    /** The scene for the files, or one that shows their errors. */
    public Scene scene(Director director) {
        if (!errors.isEmpty()) {
            return new ProblemsScene(director, errors);
        }
        return recording
                .<Scene>map(
                        watched -> new ReplayScene(director, watched, ReplayScene.Audience.PLAYER))
                .or(() -> unmade.map(replay -> new MadeReplayScene(director, replay)))
                .orElseGet(() -> new PuzzleScene(director, levels, 0));
    }
}

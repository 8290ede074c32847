package rigibo.web.build;

import rigibo.frontend.gallery.Exhibits;
import rigibo.frontend.gallery.Found;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.web.Bits;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Stream;

/**
 * The game's files in its page: levels, shaders and words in one text, which {@code
 * rigibo.web.game.Brought} reads, and the fonts.
 */
final class GameFiles {

    private final Path home;
    private final StringBuilder all = new StringBuilder();

    GameFiles(Path home) {
        this.home = home;
    }

    /** Writes the files for comparing bits: levels, and runs of them. */
    static void writeRuns(Path home, Path runs, Path to) throws IOException {
        GameFiles files = new GameFiles(home);
        files.add("levels", home.resolve("levels"), ".json");
        files.add(Bits.RUNS, runs, ".json");
        Files.writeString(to, files.all);
    }

    void write(Path folder) throws IOException {
        requireSoundLevels();
        add("levels", home.resolve("levels"), ".json");
        add("assets/shaders", home.resolve("assets/shaders"), ".glsl");
        add("words", home.resolve("build/resources/main/rigibo"), ".properties");
        add("words", home.resolve("build/resources/examples/rigibo"), ".properties");
        addSources();
        Files.writeString(folder.resolve("files.txt"), all);
        font("Quicksand-Bold.ttf", folder.resolve("words.ttf"));
        font("JetBrainsMono-Medium.ttf", folder.resolve("numbers.ttf"));
        font("Quicksand-LICENCE.txt", folder.resolve("words-licence.txt"));
        font("JetBrainsMono-LICENCE.txt", folder.resolve("numbers-licence.txt"));
    }

    /** Adds the sources of exhibits, under their names in the checkout. */
    private void addSources() throws IOException {
        for (Found found : Exhibits.all()) {
            String text = Files.readString(home.resolve(found.source()));
            all.append(found.source()).append(' ').append(text.length()).append('\n').append(text);
        }
    }

    /** Validates the levels, since the page has no schema. */
    private static void requireSoundLevels() throws IOException {
        LevelLoader loader = new LevelLoader();
        for (Path file : LevelShelf.files()) {
            LoadedLevel loaded = loader.load(file);
            if (loaded.level().isEmpty()) {
                throw new IOException("a level cannot be played: " + loaded.problems());
            }
        }
    }

    /** Adds a bundle of words under its full name. */
    private void add(String place, Path from, String ending) throws IOException {
        String before = place.equals("words") ? "rigibo." : "";
        for (Path file : files(from, ending)) {
            String text = Files.readString(file);
            all.append(place).append('/').append(before).append(file.getFileName());
            all.append(' ').append(text.length()).append('\n').append(text);
        }
    }

    private static List<Path> files(Path folder, String ending) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(ending)).sorted().toList();
        }
    }

    /** Copies a font, or its licence. */
    private void font(String name, Path to) throws IOException {
        Path from = home.resolve("assets/fonts").resolve(name);
        Files.copy(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
}

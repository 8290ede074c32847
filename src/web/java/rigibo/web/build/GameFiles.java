package rigibo.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Stream;

/**
 * The files that the game takes along into its page: levels, shaders and words in one text, which
 * {@code rigibo.web.game.Brought} reads, and the fonts.
 */
final class GameFiles {

    private final Path home;
    private final StringBuilder all = new StringBuilder();

    GameFiles(Path home) {
        this.home = home;
    }

    void write(Path folder) throws IOException {
        add("levels", home.resolve("levels"), ".json");
        add("assets/shaders", home.resolve("assets/shaders"), ".glsl");
        add("words", home.resolve("build/resources/main/rigibo"), ".properties");
        add("words", home.resolve("build/resources/examples/rigibo"), ".properties");
        Files.writeString(folder.resolve("files.txt"), all);
        font("Quicksand-Bold.ttf", folder.resolve("words.ttf"));
        font("JetBrainsMono-Medium.ttf", folder.resolve("numbers.ttf"));
    }

    /** Words are called by their bundle's whole name. */
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

    private void font(String name, Path to) throws IOException {
        Path from = home.resolve("assets/fonts").resolve(name);
        Files.copy(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
}

package rigibo.frontend.draw;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** The files the game brings along, in the folder {@code assets} of its home. */
final class Assets {

    private Assets() {}

    /** Where an asset lies. */
    static Path path(String name) {
        return Path.of(System.getProperty("rigibo.home", "."), "assets").resolve(name);
    }

    /** A shader's text. */
    static String text(String name) {
        try {
            return Files.readString(path(name), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read " + path(name), e);
        }
    }
}

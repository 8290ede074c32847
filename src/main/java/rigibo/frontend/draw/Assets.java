package rigibo.frontend.draw;

import rigibo.frontend.scene.DisplayException;

import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** The files that come with the game, in the folder {@code assets} of its home. */
final class Assets {

    private Assets() {}

    /**
     * The path of an existing asset.
     *
     * @throws DisplayException naming the file when it cannot be read
     */
    static Path path(String name) {
        Path file = place(name);
        if (!Files.isRegularFile(file) || !Files.isReadable(file)) {
            throw broken(name, Files.exists(file) ? "cannot be read" : "is missing");
        }
        return file;
    }

    private static Path place(String name) {
        return Path.of(System.getProperty("rigibo.home", "."), "assets").resolve(name);
    }

    /**
     * A shader's text.
     *
     * @throws DisplayException naming the file when it cannot be read
     */
    static String text(String name) {
        try {
            return Files.readString(path(name), StandardCharsets.UTF_8);
        } catch (MalformedInputException binary) {
            throw broken(name, "is no text");
        } catch (IOException unreadable) {
            throw broken(name, "cannot be read: " + unreadable.getMessage());
        }
    }

    /**
     * The path of a sound font.
     *
     * @throws DisplayException naming the file when it cannot be read, or is not as it was made
     */
    static Path font(String name) {
        Path file = path(name);
        try {
            if (!FontFile.isSound(Files.readAllBytes(file))) {
                throw broken(name, "is no font, or a damaged one");
            }
            return file;
        } catch (IOException unreadable) {
            throw broken(name, "cannot be read: " + unreadable.getMessage());
        }
    }

    /** Message for an asset that cannot be used, in one line, whatever a driver says. */
    static DisplayException broken(String name, String why) {
        String line = why.strip().replaceAll("\\s*\\R\\s*", "; ");
        return new DisplayException("RigiBo cannot draw: " + place(name) + " " + line);
    }
}

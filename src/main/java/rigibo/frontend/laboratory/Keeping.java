package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Director;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/** Saves tables and pictures, each into a new file, and tells where. */
final class Keeping {

    private final Director director;
    private String told = "";

    Keeping(Director director) {
        this.director = director;
    }

    /** Where the last file is, or why there is none; empty if nothing was saved. */
    String told() {
        return told;
    }

    /** Forgets the last message. */
    void forget() {
        told = "";
    }

    /** Saves a table under a name. */
    void table(String name, String text) {
        Optional<Path> file = free(name, ".csv");
        if (file.isPresent()) {
            try {
                Files.writeString(file.get(), text, StandardOpenOption.CREATE_NEW);
            } catch (IOException refused) {
                told = director.words().of("laboratory.unsaved", refused.getMessage());
            }
        }
    }

    /** Saves what the window shows next under a name. */
    void picture(String name) {
        free(name, ".png").ifPresent(director::savePicture);
    }

    /** A file that does not exist yet, in a folder that does; tells of it. */
    private Optional<Path> free(String name, String ending) {
        Optional<Path> folder = director.measurements();
        if (folder.isEmpty()) {
            told = director.words().of("laboratory.nowhere");
            return Optional.empty();
        }
        try {
            Files.createDirectories(folder.get());
            int number = 1;
            while (Files.exists(folder.get().resolve(name + "-" + number + ending))) {
                number++;
            }
            Path file = folder.get().resolve(name + "-" + number + ending);
            told = director.words().of("laboratory.saved", file);
            return Optional.of(file);
        } catch (IOException refused) {
            told = director.words().of("laboratory.unsaved", refused.getMessage());
            return Optional.empty();
        }
    }
}

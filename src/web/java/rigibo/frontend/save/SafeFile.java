package rigibo.frontend.save;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/**
 * A file of the page and its previous version. Files are in memory, and are copied to the browser's
 * storage as a whole.
 *
 * @param file its path
 */
public record SafeFile(Path file) {

    /** Puts bytes in the file's place, with no backup. */
    public void write(byte[] bytes) throws IOException {
        prepare(bytes);
        replace();
    }

    /** Writes as {@link #write} does, since files in memory are written at once. */
    public void writeWithoutWaiting(byte[] bytes) throws IOException {
        write(bytes);
    }

    Path backup() {
        return file.resolveSibling(file.getFileName() + ".backup");
    }

    private Path temporary() {
        return file.resolveSibling(file.getFileName() + ".new");
    }

    void prepare(byte[] bytes) throws IOException {
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.write(temporary(), bytes);
    }

    /** Makes the present file its backup. */
    void keep() throws IOException {
        Files.move(file, backup(), StandardCopyOption.REPLACE_EXISTING);
    }

    /** Moves the prepared file into place. */
    void replace() throws IOException {
        Files.move(temporary(), file, StandardCopyOption.REPLACE_EXISTING);
    }

    /** Gives a damaged file another name. */
    public static void setAside(Path damaged) throws IOException {
        Files.move(
                damaged,
                damaged.resolveSibling(damaged.getFileName() + ".damaged-1"),
                StandardCopyOption.REPLACE_EXISTING);
    }
}

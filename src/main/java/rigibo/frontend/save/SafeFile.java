package rigibo.frontend.save;

import static java.nio.file.StandardCopyOption.ATOMIC_MOVE;
import static java.nio.file.StandardCopyOption.REPLACE_EXISTING;
import static java.nio.file.StandardOpenOption.CREATE;
import static java.nio.file.StandardOpenOption.READ;
import static java.nio.file.StandardOpenOption.TRUNCATE_EXISTING;
import static java.nio.file.StandardOpenOption.WRITE;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A file, its previous version as a backup, and damaged ones that were set aside. At any moment,
 * even if the power fails, the file or its backup is whole.
 *
 * @param file its path
 */
public record SafeFile(Path file) {

    /**
     * Replaces the file by bytes, without a backup.
     *
     * @throws IOException when they cannot be written; the file is then unchanged
     */
    public void write(byte[] bytes) throws IOException {
        prepare(bytes);
        replace();
    }

    /**
     * Replaces the file by bytes without waiting for the disk, which would delay a frame. If the
     * game ends meanwhile, the file is the old or the new one; if the power fails, it may be
     * neither.
     *
     * @throws IOException when they cannot be written; the file is then unchanged
     */
    public void writeWithoutWaiting(byte[] bytes) throws IOException {
        fill(bytes, channel -> {});
        move();
    }

    Path backup() {
        return file.resolveSibling(file.getFileName() + ".backup");
    }

    /** Belongs to this process alone, since two games may run at once. */
    private Path temporary() {
        return file.resolveSibling(file.getFileName() + "." + ProcessHandle.current().pid());
    }

    /** Writes bytes to a file beside this one and syncs it to disk; removes it if that fails. */
    void prepare(byte[] bytes) throws IOException {
        fill(bytes, channel -> channel.force(true));
    }

    private interface Last {
        void on(FileChannel channel) throws IOException;
    }

    private void fill(byte[] bytes, Last last) throws IOException {
        Files.createDirectories(file.toAbsolutePath().getParent());
        boolean isDone = false;
        try (FileChannel channel =
                FileChannel.open(temporary(), CREATE, TRUNCATE_EXISTING, WRITE)) {
            ByteBuffer left = ByteBuffer.wrap(bytes);
            while (left.hasRemaining()) {
                channel.write(left);
            }
            last.on(channel);
            isDone = true;
        } finally {
            if (!isDone) {
                Files.deleteIfExists(temporary());
            }
        }
    }

    /** Makes the present file its backup. */
    void keep() throws IOException {
        Files.move(file, backup(), ATOMIC_MOVE, REPLACE_EXISTING);
    }

    /** Moves the prepared file into place. */
    void replace() throws IOException {
        move();
        if (!System.getProperty("os.name").startsWith("Windows")) {
            // Moves are of the folder; Windows neither needs this nor lets folders be opened.
            try (FileChannel folder = FileChannel.open(file.toAbsolutePath().getParent(), READ)) {
                folder.force(true);
            }
        }
    }

    private void move() throws IOException {
        Files.move(temporary(), file, ATOMIC_MOVE, REPLACE_EXISTING);
    }

    /**
     * Gives a damaged file the first free of its names with a number.
     *
     * @throws IOException when it cannot be moved; it is where it was
     */
    public static void setAside(Path damaged) throws IOException {
        int number = 1;
        while (Files.exists(aside(damaged, number))) {
            number++;
        }
        Files.move(damaged, aside(damaged, number));
    }

    private static Path aside(Path damaged, int number) {
        return damaged.resolveSibling(damaged.getFileName() + ".damaged-" + number);
    }
}

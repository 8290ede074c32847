package rigibo.frontend.save;

import static java.nio.file.StandardOpenOption.CREATE;
import static java.nio.file.StandardOpenOption.WRITE;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;

/**
 * Lets only one game at a time read, merge and replace the files of a folder. The operating system
 * holds the lock, on a file of its own, and releases it when the process ends, in whatever way.
 * Threads of one process use this class's monitor, since the system's locks belong to processes.
 */
public final class FolderLock {

    /** Time between two tries, ns. */
    private static final long PAUSE = 2_000_000;

    private final Path folder;
    private final Duration patience;
    private final Locking locking;

    /** The work done under the lock. */
    public interface Work {
        void run() throws IOException;
    }

    /** How a file is locked; the lock is null where another process holds it. */
    interface Locking {
        FileLock tryLock(FileChannel channel) throws IOException;
    }

    /**
     * The lock of a folder, which need not exist yet.
     *
     * @param patience how long another game is waited for
     */
    public FolderLock(Path folder, Duration patience) {
        this(folder, patience, FileChannel::tryLock);
    }

    FolderLock(Path folder, Duration patience, Locking locking) {
        this.folder = folder;
        this.patience = patience;
        this.locking = locking;
    }

    /**
     * Works while no other game does. If no lock can be had, because the file system has none or
     * another game was stopped while it held it, works all the same.
     *
     * @return whether the lock was held
     * @throws IOException what the work throws
     */
    public boolean during(Work work) throws IOException {
        synchronized (FolderLock.class) {
            Optional<FileChannel> held = taken();
            try {
                work.run();
            } finally {
                held.ifPresent(FolderLock::release);
            }
            return held.isPresent();
        }
    }

    private Optional<FileChannel> taken() {
        try {
            Files.createDirectories(folder);
            FileChannel channel = FileChannel.open(folder.resolve(".lock"), CREATE, WRITE);
            return isLocked(channel) ? Optional.of(channel) : Optional.empty();
        } catch (IOException noneHere) {
            return Optional.empty();
        }
    }

    /** Closes the channel where it cannot be locked. */
    private boolean isLocked(FileChannel channel) throws IOException {
        long begin = System.nanoTime();
        boolean isLocked = false;
        try {
            isLocked = locking.tryLock(channel) != null;
            while (!isLocked && System.nanoTime() - begin < patience.toNanos()) {
                LockSupport.parkNanos(PAUSE);
                isLocked = locking.tryLock(channel) != null;
            }
        } finally {
            if (!isLocked) {
                channel.close();
            }
        }
        return isLocked;
    }

    private static void release(FileChannel held) {
        try {
            held.close();
        } catch (IOException gone) {
            // The work is done, and the system takes the lock back when the process ends.
        }
    }
}

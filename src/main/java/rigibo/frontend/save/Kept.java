package rigibo.frontend.save;

import org.tinylog.Logger;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A value and its file. The loop owns the value; another thread writes the file and alone waits for
 * the disk.
 */
final class Kept<T> {

    /**
     * Time for which another game that is writing is waited for; even a slow disk is done by then.
     */
    private static final Duration PATIENCE = Duration.ofSeconds(2);

    private final SafeFile file;
    private final FolderLock lock;
    private final Format<T> format;
    private final List<Notice> notices = new ArrayList<>();
    private T value;

    /** The content of the file, as far as we know. */
    private T saved;

    private boolean isUnwritable;
    private boolean isForeign;

    /** Whether a damaged file is still in its place. */
    private boolean isStuck;

    private boolean wasUnlocked;

    /** Reads a value from its file, or from its backup. */
    Kept(Path path, Format<T> format) {
        this(path, format, new FolderLock(path.getParent(), PATIENCE));
    }

    Kept(Path path, Format<T> format, FolderLock lock) {
        file = new SafeFile(path);
        this.format = format;
        this.lock = lock;
        saved = load();
        value = saved;
    }

    private T load() {
        Reading<T> reading = read(file.file());
        return switch (reading.state()) {
            case WHOLE -> reading.value().orElseThrow();
            case MISSING -> {
                Reading<T> backup = backup();
                if (backup.state() == Reading.State.DAMAGED) {
                    notices.add(
                            isStuck
                                    ? new Notice(Notice.Kind.STUCK, file.backup())
                                    : new Notice(Notice.Kind.BACKUP_LOST, file.file()));
                }
                yield backup.value().orElseGet(format::initial);
            }
            case DAMAGED -> {
                putAside(file.file());
                Optional<T> backup = backup().value();
                Notice.Kind moved = backup.isPresent() ? Notice.Kind.BACKUP_USED : Notice.Kind.LOST;
                note(isStuck ? Notice.Kind.STUCK : moved);
                yield backup.orElseGet(format::initial);
            }
            case NEWER -> {
                isForeign = true;
                note(Notice.Kind.NEWER);
                yield format.initial();
            }
            case UNREADABLE -> {
                note(Notice.Kind.UNREADABLE);
                yield backup().value().orElseGet(format::initial);
            }
        };
    }

    private Reading<T> read(Path path) {
        Reading<T> reading = Reading.of(path, format);
        reading.problems().stream().findFirst().ifPresent(Logger::warn);
        return reading;
    }

    /** Reads the backup, and sets it aside if it is damaged. */
    private Reading<T> backup() {
        Reading<T> reading = read(file.backup());
        if (reading.state() == Reading.State.DAMAGED) {
            putAside(file.backup());
        }
        isForeign |= reading.state() == Reading.State.NEWER;
        return reading;
    }

    /** Where even this cannot be written, the file stays, and no other takes its place. */
    private void putAside(Path damaged) {
        try {
            SafeFile.setAside(damaged);
        } catch (IOException readOnly) {
            isStuck = true;
            isUnwritable = true;
        }
    }

    private synchronized void note(Notice.Kind kind) {
        notices.add(new Notice(kind, file.file()));
    }

    synchronized T value() {
        return value;
    }

    synchronized void value(T changed) {
        value = changed;
    }

    /** The notices about this file, with the present state last. */
    synchronized List<Notice> notices() {
        List<Notice> all = new ArrayList<>(notices);
        if (isUnwritable) {
            all.add(new Notice(Notice.Kind.UNSAVED, file.file()));
        }
        return all;
    }

    /** Removes the notices, since the player has read them; one that still holds is made anew. */
    synchronized void forgetNotices() {
        notices.clear();
    }

    /**
     * Writes the value if the file does not have it yet.
     *
     * @return whether there is nothing left to try
     */
    boolean save() {
        T wanted = value();
        if (isForeign || wanted.equals(saved())) {
            return true;
        }
        try {
            if (!lock.during(() -> write(wanted))) {
                unlocked();
            }
            wrote(wanted);
            return true;
        } catch (IOException full) {
            failed();
            return false;
        }
    }

    private synchronized T saved() {
        return saved;
    }

    /** Once is enough: it will hold of this folder for as long as the game runs. */
    private synchronized void unlocked() {
        if (!wasUnlocked) {
            note(Notice.Kind.UNLOCKED);
        }
        wasUnlocked = true;
    }

    private synchronized void wrote(T written) {
        saved = written;
        isUnwritable = false;
    }

    private synchronized void failed() {
        isUnwritable = true;
    }

    /** Under the lock. The old file is touched only once the new one is on the disk. */
    private void write(T wanted) throws IOException {
        Reading<T> present = Reading.of(file.file(), format);
        Reading.State state = present.state();
        if (state == Reading.State.NEWER || state == Reading.State.UNREADABLE) {
            throw new IOException(file.file() + " is not ours to replace");
        }
        T merged =
                present.value().map(found -> format.merged(saved(), found, wanted)).orElse(wanted);
        file.prepare(Reading.bytes(merged, format));
        if (state == Reading.State.WHOLE) {
            file.keep();
        } else if (state == Reading.State.DAMAGED) {
            SafeFile.setAside(file.file());
            note(Notice.Kind.REPLACED);
        }
        file.replace();
    }
}

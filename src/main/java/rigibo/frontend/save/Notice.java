package rigibo.frontend.save;

import rigibo.frontend.scene.Words;

import java.nio.file.Path;
import java.util.Locale;

/**
 * A message to the player about a file.
 *
 * @param kind its kind
 * @param file the file
 */
record Notice(Kind kind, Path file) {

    enum Kind {
        /** The file was damaged; the one before is used. */
        BACKUP_USED,
        /** The file was damaged and there is no other. */
        LOST,
        /** There is no file, and its backup was damaged. */
        BACKUP_LOST,
        /** The file is damaged and could not be moved: it stays unchanged and unused. */
        STUCK,
        /** The file was damaged, and moved when another took its place. */
        REPLACED,
        /** A newer game wrote it: it stays unchanged. */
        NEWER,
        /** It cannot be read: it stays unchanged. */
        UNREADABLE,
        /** It cannot be written, and will be tried again. */
        UNSAVED,
        /** It is written, but without a lock: two games at once may undo what the other saves. */
        UNLOCKED
    }

    String in(Words words) {
        String key = "save." + kind.name().toLowerCase(Locale.ROOT).replace('_', '-');
        return words.of(key, file.getFileName(), file.toAbsolutePath().getParent());
    }
}

package rigibo.frontend.editor;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.editor.file.Unreadable;
import rigibo.frontend.editor.file.Unsaved;
import rigibo.frontend.puzzle.ProblemWords;
import rigibo.frontend.save.Places;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The file of the present draft, and drafts that were left unsaved earlier. */
final class Drawer {

    /** Where drafts of a player without files are saved: nowhere. */
    private final Optional<Path> folder;

    /** The content of the file; empty if it is not known. */
    private Optional<Draft> written;

    private Optional<Path> file;
    private Optional<Path> kept = Optional.empty();
    private Optional<Unsaved.Left> offered = Optional.empty();
    private Optional<IOException> trouble = Optional.empty();

    Drawer(Optional<Path> folder, DraftFile first) {
        this.folder = folder;
        written = Optional.of(first.draft());
        file = first.file();
        folder.ifPresent(own -> offer());
    }

    private void offer() {
        Unsaved unsaved = unsaved();
        try {
            offered = unsaved.last();
            trouble = unsaved.trouble().stream().findFirst();
        } catch (IOException unreadable) {
            trouble = Optional.of(unreadable);
        }
    }

    private Unsaved unsaved() {
        return new Unsaved(Places.drafts(folder.orElseThrow()));
    }

    private DraftFiles own() {
        return new DraftFiles(folder);
    }

    /**
     * A sentence about what is wrong with a file or code; if the disk refuses, the system's own
     * message.
     */
    static String told(Words words, IOException why) {
        if (why instanceof Unreadable unreadable) {
            String key = unreadable.isSetAside() ? "editor.say.aside" : "editor.say.trouble";
            return words.of(key, ProblemWords.told(words, unreadable.problem()));
        }
        return words.of("editor.say.refused", why.getMessage());
    }

    /** The problem found when the editor opened, if any. */
    Optional<IOException> trouble() {
        return trouble;
    }

    /** The draft that was left unsaved last time. */
    Optional<Unsaved.Left> offered() {
        return offered;
    }

    /** The file that the draft belongs to. */
    Optional<Path> file() {
        return file;
    }

    boolean isSaved(Draft draft) {
        return written.filter(draft::equals).isPresent();
    }

    List<Path> files() throws IOException {
        return own().all();
    }

    DraftFile save(Draft draft) throws IOException {
        DraftFile saved = own().save(new DraftFile(draft, file));
        written = Optional.of(saved.draft());
        file = saved.file();
        if (kept.isPresent()) {
            unsaved().forget(kept.get());
            kept = Optional.empty();
        }
        return saved;
    }

    /** Keeps an unsaved draft; returns why if that fails. */
    Optional<IOException> put(Draft draft) {
        if (folder.isEmpty() || isSaved(draft)) {
            return Optional.empty();
        }
        try {
            kept = Optional.of(unsaved().keep(new DraftFile(draft, file), kept));
            return Optional.empty();
        } catch (IOException full) {
            return Optional.of(full);
        }
    }

    /** Notes that another draft lies on the desk. */
    void take(DraftFile other) {
        written = Optional.of(other.draft());
        file = other.file();
        kept = Optional.empty();
    }

    /** Notes that the draft left unsaved lies on the desk, which need not agree with its file. */
    void takeUp() {
        offered.ifPresent(
                left -> {
                    written = Optional.empty();
                    file = left.left().file();
                    kept = Optional.of(left.kept());
                });
        offered = Optional.empty();
    }

    /** Discards the draft that was left unsaved; returns why if that fails. */
    Optional<IOException> refuse() {
        Optional<Path> old = offered.map(Unsaved.Left::kept);
        offered = Optional.empty();
        try {
            if (old.isPresent()) {
                unsaved().forget(old.get());
            }
            return Optional.empty();
        } catch (IOException locked) {
            return Optional.of(locked);
        }
    }
}

package rigibo.frontend.editor;

import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;

/** Opens the editor. */
public final class Editor {

    private Editor() {}

    /** The editor among the game's scenes, with a new level. */
    public static SceneEntry entry() {
        return SceneEntry.of(
                "editor",
                director ->
                        new EditorScene(
                                director, new DraftFile(NewLevel.draft(), Optional.empty())));
    }

    /**
     * An editor with the level of a file; where there is none, with a new one that is saved there.
     *
     * @throws IllegalArgumentException when it is no level that can be edited, saying why
     */
    public static Function<Director, Scene> of(Path file) {
        try {
            DraftFile opened = DraftFiles.open(file);
            return director -> new EditorScene(director, opened);
        } catch (IOException unreadable) {
            throw new IllegalArgumentException(unreadable.getMessage(), unreadable);
        }
    }
}

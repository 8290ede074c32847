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

    /** Menu entry of the editor, which opens it with a new level. */
    public static SceneEntry entry() {
        return SceneEntry.of(
                EditorScene.NAME,
                director ->
                        new EditorScene(
                                director, new DraftFile(NewLevel.draft(), Optional.empty())));
    }

    /**
     * Opens the editor with the level of a file; if the file does not exist, with a new level that
     * will be saved there.
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

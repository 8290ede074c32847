package rigibo.frontend.editor.file;

import rigibo.frontend.editor.draft.Draft;

import tools.jackson.databind.node.JsonNodeFactory;

import java.nio.file.Path;
import java.util.Optional;

/**
 * A draft and its file.
 *
 * @param draft as it stands in the file
 * @param file path of the file; nothing for a draft that was never saved
 */
public record DraftFile(Draft draft, Optional<Path> file) {

    /** Returns this file with the level's id changed. */
    DraftFile called(String id) {
        return new DraftFile(draft.with("/id", JsonNodeFactory.instance.stringNode(id)), file);
    }
}

package rigibo.fuzz.file;

import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.puzzle.level.LevelShelf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Reads a level, finished or not, as the editor does. */
final class DraftReader implements Reader {

    @Override
    public String title() {
        return "draft";
    }

    @Override
    public List<Sample> samples(Path folder) throws IOException {
        DraftFiles files = new DraftFiles(Optional.of(folder));
        DraftFile begun = DraftFiles.open(folder.resolve("begun.json"));
        Path saved = files.save(begun).file().orElseThrow();
        return List.of(
                new Sample("draft.json", Files.readAllBytes(saved)),
                new Sample("draft.json", Files.readAllBytes(LevelShelf.files().get(0))));
    }

    @Override
    public String read(Path file) throws Refused {
        try {
            DraftFile opened = DraftFiles.open(file);
            new DraftFiles(Optional.of(file.getParent())).save(opened);
            return "";
        } catch (IOException told) {
            throw new Refused(told);
        }
    }
}

package rigibo.fuzz.file;

import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.editor.file.Unsaved;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Reads an unsaved draft, which the editor offers when it opens. */
final class UnsavedReader implements Reader {

    @Override
    public String title() {
        return "unsaved";
    }

    @Override
    public List<Sample> samples(Path folder) throws IOException {
        Unsaved unsaved = new Unsaved(folder);
        Path kept = unsaved.keep(DraftFiles.open(folder.resolve("none.json")), Optional.empty());
        return List.of(new Sample("1.unsaved.json", Files.readAllBytes(kept)));
    }

    @Override
    public String read(Path file) throws Refused {
        try {
            boolean isOffered = new Unsaved(file.getParent()).last().isPresent();
            return isOffered ? "" : "it is set aside, or stays for the newer game that wrote it";
        } catch (IOException told) {
            throw new Refused(told);
        }
    }
}

package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.frontend.document.Mutations;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.file.Unsaved;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.scene.Key;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** A draft that was left unsaved and then damaged ended the editor as soon as it was taken up. */
class MutatedDraftsTest {

    private static final String TRIANGLE =
            "{\"type\": \"polygon\", \"points\": [[0, 0], [1, 0], [0, 1]]}";

    @TempDir Path folder;

    @Test
    void noValueOfAnyPartIsWorseThanADraftSetAside() {
        String level =
                LevelTexts.with("{\"type\": \"box\", \"w\": 0.5, \"h\": 4}", TRIANGLE)
                        .replace("\"radius\"", "\"material\": \"ice\", \"radius\"");
        Mutations.someOf("{\"file\": \"a.json\", \"level\": " + level + "}")
                .forEach(this::assertTakenUpOrSetAside);
    }

    private void assertTakenUpOrSetAside(String mutated) {
        String shown = mutated.substring(0, Math.min(1500, mutated.length()));
        Path kept = folder.resolve("1.unsaved.json");
        try {
            Files.writeString(kept, mutated);
            Unsaved unsaved = new Unsaved(folder);
            Optional<DraftFile> left = unsaved.last().map(Unsaved.Left::left);
            boolean isNewer = mutated.contains("\"format\":9e15");
            assertThat(left.isPresent() || isNewer)
                    .as(shown)
                    .isEqualTo(unsaved.trouble().isEmpty());
            assertThat(Files.exists(kept)).as(shown).isEqualTo(unsaved.trouble().isEmpty());
            left.ifPresent(draft -> use(draft, shown));
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    private static void use(DraftFile draft, String shown) {
        try {
            Author author = new Author(draft, Optional.empty(), "en");
            assertThat(author.look().texts()).as(shown).isNotEmpty();
            author.scene.keyPressed(Key.TAB);
            author.look();
        } catch (RuntimeException ended) {
            throw new AssertionError(shown, ended);
        }
    }
}

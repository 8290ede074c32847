package rigibo.frontend.editor.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.NewLevel;

import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

class DraftFilesTest {

    @TempDir private Path folder;

    @ParameterizedTest
    @CsvSource({
        "Two Storeys, two-storeys",
        "Große Brücke!, grosse-brucke",
        "'  ', new-level",
        "Ελλάδα, new-level",
        "Aaaaaaaaaaaa Bbbbbbbbbbbb Cccccccccc Dddd, aaaaaaaaaaaa-bbbbbbbbbbbb-cccccccccc"
    })
    void titlesBecomeIdsThatTheSchemaTakes(String title, String id) {
        assertThat(DraftFiles.word(title)).isEqualTo(id);
    }

    @Test
    void twoNewLevelsOfOneTitleGetTwoFiles() throws IOException {
        DraftFiles files = new DraftFiles(Optional.of(folder));
        DraftFile fresh = new DraftFile(NewLevel.draft(), Optional.empty());
        assertThat(files.save(fresh).file()).contains(folder.resolve("new-level.json"));
        DraftFile second = files.save(fresh);
        assertThat(second.file()).contains(folder.resolve("new-level-2.json"));
        assertThat(second.draft().at("/id").asString()).isEqualTo("new-level-2");
    }

    @Test
    void aTitleOfTheGamesOwnGetsAnotherId() throws IOException {
        Draft seesaw = DraftFiles.open(games("seesaw")).draft();
        DraftFiles files = new DraftFiles(Optional.of(folder));
        assertThat(files.save(new DraftFile(seesaw, Optional.of(games("seesaw")))).file())
                .contains(folder.resolve("seesaw-2.json"));
    }

    /** A level of 20,000 bodies has two megabytes, of which one is read. */
    @Test
    void whatCouldNotBeReadAgainIsNotSaved() throws IOException {
        DraftFiles files = new DraftFiles(Optional.of(folder));
        DraftFile small = files.save(new DraftFile(NewLevel.draft(), Optional.empty()));
        String before = Files.readString(small.file().orElseThrow());
        ObjectNode level = (ObjectNode) small.draft().document().deepCopy();
        ArrayNode bodies = level.putArray("bodies");
        for (int i = 0; i < 20_000; i++) {
            bodies.addObject()
                    .put("id", "body-" + i)
                    .put("shape", "a box, and a large one at that");
        }
        DraftFile large = new DraftFile(Draft.of(level), small.file());

        assertThatThrownBy(() -> files.save(large))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("could not be read again")
                .hasMessageContaining("larger than 1000000 bytes");
        assertThat(Files.readString(small.file().orElseThrow())).isEqualTo(before);
        Unsaved unsaved = new Unsaved(folder.resolve("drafts"));
        assertThatThrownBy(() -> unsaved.keep(large, Optional.empty()))
                .hasMessageContaining("could not be read again");
    }

    private Path games(String id) throws IOException {
        return new DraftFiles(Optional.of(folder))
                .all().stream()
                        .filter(file -> file.toString().endsWith("-" + id + ".json"))
                        .findFirst()
                        .orElseThrow();
    }

    @Test
    void whatIsNoLevelIsRefusedWithTheReason() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.json"), "{");
        assertThatThrownBy(() -> DraftFiles.open(broken)).hasMessageContaining("not JSON");
        Path newer = Files.writeString(folder.resolve("newer.json"), "{\"format\": 3}");
        assertThatThrownBy(() -> DraftFiles.open(newer)).hasMessageContaining("newer RigiBo");
    }

    @Test
    void withoutAFolderThereIsNowhereToSave() {
        DraftFiles files = new DraftFiles(Optional.empty());
        DraftFile fresh = new DraftFile(NewLevel.draft(), Optional.empty());
        assertThatThrownBy(() -> files.save(fresh)).isInstanceOf(IOException.class);
    }
}

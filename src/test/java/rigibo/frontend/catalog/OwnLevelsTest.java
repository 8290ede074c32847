package rigibo.frontend.catalog;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.click;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Levels that a player made, in the list of levels. */
class OwnLevelsTest {

    @TempDir private Path folder;

    private final RecordingDirector director = new RecordingDirector();

    private void keep(int count) throws IOException {
        director.levels = Optional.of(folder);
        List<Path> files = LevelShelf.files();
        for (int i = 0; i < count; i++) {
            Files.copy(files.get(i), folder.resolve(files.get(i).getFileName().toString()));
        }
    }

    private Scene opened(String button) {
        Scene levels = Catalog.levels(director);
        click(levels, button);
        return director.shown.get(director.shown.size() - 1);
    }

    @Test
    void theListLeadsToThemOnceThereAreAny() throws IOException {
        director.levels = Optional.of(folder);
        assertThat(RecordingCanvas.of(Catalog.levels(director)).texts())
                .contains("Endless")
                .doesNotContain("Your levels");
        keep(4);
        Files.writeString(folder.resolve("broken.json"), "{}");
        Scene own = opened("Your levels");
        assertThat(RecordingCanvas.of(own).texts())
                .as("all of them open")
                .contains("Two Storeys", "Tilt", "Gold for 2 clicks")
                .contains("One more has mistakes: the editor says which.");
        own.keyPressed(Key.ENTER);
        assertThat(director.shown.get(1).title()).contains("Two Storeys");
        assertThat(own.escaped()).isTrue();
        assertThat(director.asked).containsExactly("levels");
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void theyCanBeReadPageByPage(String language) throws IOException {
        RecordingDirector told = new RecordingDirector(language);
        keep(14);
        told.levels = Optional.of(folder);
        assertThat(Legibility.faults(Catalog.levels(told))).isEmpty();
        Scene levels = Catalog.levels(told);
        String button = language.equals("de") ? "Deine Level" : "Your levels";
        click(levels, button);
        Scene own = told.shown.get(0);
        assertThat(Legibility.faults(own)).isEmpty();
        assertThat(RecordingCanvas.of(own).texts()).contains("1 / 2");
        click(own, "›");
        assertThat(RecordingCanvas.of(own).texts()).contains("2 / 2");
        assertThat(Legibility.faults(own)).isEmpty();
        own.scrolled(1, 0, 0);
        assertThat(RecordingCanvas.of(own).texts()).contains("1 / 2");
    }

    /** The page keeps what its editor saves, too. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void theyFitPhones(String language) throws IOException {
        RecordingDirector told = new RecordingDirector(language);
        keep(14);
        Files.writeString(folder.resolve("broken.json"), "{}");
        told.levels = Optional.of(folder);
        Scene levels = Catalog.levels(told);
        click(levels, language.equals("de") ? "Deine Level" : "Your levels");
        Scene own = told.shown.get(0);
        assertThat(Legibility.faultsInHand(own)).isEmpty();
        for (Layout hand : Legibility.HANDS) {
            assertThat(RecordingCanvas.of(own, hand).texts()).contains("‹", "›");
        }
    }
}

package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.RecordingNarrator;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Screen readers describe levels in words. */
class NarratedLevelTest {

    static Stream<Path> levels() {
        return LevelShelf.files().stream();
    }

    private static Level level(Path file) throws IOException {
        return new LevelLoader().load(file).level().orElseThrow();
    }

    private static RecordingNarrator told(PuzzleScene scene) {
        RecordingCanvas.of(scene);
        return RecordingNarrator.of(scene);
    }

    @ParameterizedTest
    @MethodSource("levels")
    void allThatCanBeClickedHasANameOfItsOwn(Path file) throws IOException {
        Level level = level(file);
        PuzzleScene scene = PuzzleScene.ofTrial(new RecordingDirector(), level);
        List<String> before = told(scene).names();
        assertThat(before).doesNotHaveDuplicates();
        scene.keyPressed(Key.TAB);
        assertThat(told(scene).controls()).filteredOn(control -> control.isChosen()).hasSize(1);
        scene.closed();
    }

    @ParameterizedTest
    @CsvSource({"en, 'RigiBo box, ', The ball begins: ", "de, 'Kasten aus RigiBo, ', Der Ball"})
    void aBoxIsDeletedByItsName(String language, String box, String start) throws IOException {
        Level first = level(LevelShelf.files().get(0));
        PuzzleScene scene = PuzzleScene.ofTrial(new RecordingDirector(language), first);
        RecordingNarrator told = told(scene);
        assertThat(told.said()).anyMatch(words -> words.startsWith(start));
        List<String> boxes = told.names().stream().filter(name -> name.startsWith(box)).toList();
        RecordingNarrator.press(scene, told.control(boxes.get(0)));
        scene.step();
        assertThat(told(scene).names().stream().filter(name -> name.startsWith(box)))
                .hasSize(boxes.size() - 1);
        scene.closed();
    }
}

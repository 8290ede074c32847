package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.document.Cause;
import rigibo.frontend.document.ShareCode;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.Recordings;
import rigibo.frontend.puzzle.replay.ReplayCode;
import rigibo.frontend.puzzle.replay.ReplayShelf;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

class PlayerFilesTest {

    @TempDir Path folder;

    private final RecordingDirector director = new RecordingDirector();
    private Path level;
    private Path replay;

    @BeforeEach
    void write() throws IOException {
        Recording recording = Recordings.sound();
        ReplayShelf shelf = new ReplayShelf(folder, recording.level());
        shelf.keep(recording);
        replay = shelf.best();
        level = Files.writeString(folder.resolve("drop.json"), LevelTexts.SOUND);
    }

    private Scene open(Path... files) {
        return PlayerFiles.read(List.of(files)).scene(director);
    }

    @Test
    void aLevelIsPlayed() {
        assertThat(open(level)).isInstanceOf(PuzzleScene.class);
    }

    @Test
    void aReplayIsWatchedWithTheLevelItComesWith() {
        assertThat(open(replay, level)).isInstanceOf(ReplayScene.class);
        assertThat(open(level, replay)).isInstanceOf(ReplayScene.class);
    }

    @Test
    void aReplayOfNoKnownLevelIsRefusedInWords() {
        Scene scene = open(replay);
        assertThat(String.join("", RecordingCanvas.of(scene).texts()))
                .contains("This cannot be opened", "a level that is not here");
        assertThatThrownBy(() -> PlayerFiles.read(List.of(replay)).sound())
                .hasMessageContaining("belongs to the level \"drop\", which is not here");
    }

    @Test
    void theLevelsOfAFolderArePlayedInTheOrderOfTheirNames() throws IOException {
        Path pack = Files.createDirectory(folder.resolve("pack"));
        Files.writeString(pack.resolve("2.json"), LevelTexts.SOUND);
        Files.writeString(pack.resolve("1.json"), LevelTexts.with("\"Drop\"", "\"First\""));
        Scene scene = open(pack);
        assertThat(scene.title()).contains("First");
        assertThat(RecordingCanvas.of(open(folder.resolve("none.zip"))).texts())
                .contains("This cannot be opened");
    }

    private Scene paste(String code) {
        return PlayerFiles.pasted(director, code).orElseThrow();
    }

    private static String code(String level) {
        JsonNode document = JsonMapper.shared().readTree(level);
        return ShareCode.of(ShareCode.Kind.LEVEL, document).orElseThrow();
    }

    @Test
    void theLevelOfACodeIsPlayed() {
        assertThat(paste(code(LevelTexts.SOUND))).isInstanceOf(PuzzleScene.class);
    }

    @Test
    void eachLevelOfTheGameHasACode() throws IOException {
        for (Path file : LevelShelf.files()) {
            assertThat(paste(code(Files.readString(file)))).isInstanceOf(PuzzleScene.class);
        }
    }

    @Test
    void theReplayOfACodeIsWatchedIfItsLevelIsOneOfTheGame() {
        Recording known = Recordings.of(Levels.all().get(0), Accuracy.GAME);
        assertThat(paste(ReplayCode.of(known).orElseThrow())).isInstanceOf(ReplayScene.class);
        Recording foreign = Recordings.sound();
        assertThat(RecordingCanvas.of(paste(ReplayCode.of(foreign).orElseThrow())).texts())
                .anyMatch(words -> words.contains("a level that is not here"));
    }

    @Test
    void whatIsWrongWithACodeIsTold() {
        String whole = code(LevelTexts.SOUND);
        Scene cut = paste(whole.substring(0, whole.length() - 9));
        assertThat(String.join("", RecordingCanvas.of(cut).texts())).contains("is damaged");
        Scene unsound = paste(code(LevelTexts.with("\"radius\": 0.35", "\"radius\": -1")));
        assertThat(String.join("", RecordingCanvas.of(unsound).texts())).contains("/ball/radius");
        assertThat(PlayerFiles.pasted(director, "something else")).isEmpty();
    }

    /** A refused file or code is explained in the player's language. */
    @Test
    void everyCauseIsToldInGerman() throws IOException {
        director.settings(director.settings().withLanguage("de"));
        String whole = code(LevelTexts.SOUND);
        assertThat(texts(paste(whole.substring(0, whole.length() - 9)))).contains("beschädigt");
        assertThat(texts(open(folder.resolve("none.json")))).contains("noch da");
        assertThat(texts(open(replay))).contains("das hier fehlt");
        assertThat(texts(open(Files.createDirectory(folder.resolve("empty"))))).contains("weder");
        Path newer = folder.resolve("newer.json");
        Files.writeString(newer, LevelTexts.with("\"format\": 1", "\"format\": 9"));
        assertThat(texts(open(newer))).contains("ein neueres RigiBo");
        for (Cause cause : Cause.values()) {
            assertThat(director.words().of(cause.key())).isNotBlank();
        }
    }

    private static String texts(Scene scene) {
        return String.join(" ", RecordingCanvas.of(scene).texts());
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void manyProblemsOfFilesFarAwayCanBeRead(String language) throws IOException {
        List<Path> files = new ArrayList<>();
        Path far = Files.createDirectories(folder.resolve("x".repeat(120)));
        for (int i = 0; i < 40; i++) {
            files.add(far.resolve(i + ".json"));
        }
        Scene scene = PlayerFiles.read(files).scene(new RecordingDirector(language));
        assertThat(Legibility.faults(scene)).isEmpty();
        assertThat(RecordingCanvas.of(scene).texts())
                .anySatisfy(words -> assertThat(words).matches("(and|und) \\d+ (more|mehr)"));
    }
}

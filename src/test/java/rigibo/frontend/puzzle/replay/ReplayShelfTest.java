package rigibo.frontend.puzzle.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.level.Solution;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

class ReplayShelfTest {

    @TempDir Path folder;

    private final Level level =
            LevelTexts.level(
                    LevelTexts.with(
                            "\"material\": \"stone\", \"dynamic\": false",
                            "\"material\": \"stone\", \"dynamic\": false, \"deletable\": true"));
    private final Recording quick = run(new Click(0.5, "box"));
    private final Recording slow = run(new Click(2, "box"));
    private final Recording wasteful = run(new Click(0, "box"), new Click(1, "wall"));
    private ReplayShelf shelf;

    @BeforeEach
    void makeShelf() {
        shelf = new ReplayShelf(folder.resolve("replays"), level);
    }

    private Recording run(Click... clicks) {
        return Recording.of(level, new Solution(List.of(clicks)), Accuracy.GAME, 1200);
    }

    private Recording read(Path file) {
        return new ReplayLoader(List.of(level)).load(file).recording().orElseThrow();
    }

    @Test
    void theFirstRunIsTheLastAndTheBest() throws IOException {
        shelf.keep(slow);
        assertThat(read(shelf.best())).isEqualTo(slow);
        assertThat(read(shelf.last())).isEqualTo(slow);
    }

    @Test
    void fewerClicksAreBetterThenLessTime() throws IOException {
        shelf.keep(wasteful);
        shelf.keep(slow);
        assertThat(read(shelf.best())).isEqualTo(slow);
        shelf.keep(quick);
        assertThat(read(shelf.best())).isEqualTo(quick);
    }

    @Test
    void aWorseRunIsTheLastOnly() throws IOException {
        shelf.keep(quick);
        shelf.keep(wasteful);
        assertThat(read(shelf.best())).isEqualTo(quick);
        assertThat(read(shelf.last())).isEqualTo(wasteful);
        assertThat(shelf.watchable()).contains(quick);
    }

    @Test
    void twoFilesOfALevelAreAllThereIs() throws IOException {
        for (Recording run : List.of(quick, slow, wasteful, quick)) {
            shelf.keep(run);
        }
        try (Stream<Path> files = Files.list(folder.resolve("replays"))) {
            assertThat(files.filter(file -> !file.endsWith(".lock")))
                    .containsExactlyInAnyOrder(shelf.best(), shelf.last());
        }
    }

    @Test
    void aBestThatCannotBeWatchedAnyMoreMakesRoom() throws IOException {
        shelf.keep(quick);
        Files.writeString(shelf.best(), "{");
        shelf.keep(wasteful);
        assertThat(read(shelf.best())).isEqualTo(wasteful);
    }

    /** Files as another revision of the simulation would have written them. */
    @Test
    void runsOfAnotherRevisionAreToldKeptAndNeverPlayed() throws IOException {
        shelf.keep(quick);
        String revision = "\"revision\" : " + Pool.REVISION;
        String sound = Files.readString(shelf.best());
        assertThat(sound).contains(revision);
        String other = sound.replace(revision, "\"revision\" : 99");
        Files.writeString(shelf.best(), other);
        Files.writeString(shelf.last(), other);
        assertThat(shelf.watchable()).isEmpty();
        assertThat(shelf.ofOtherRevisions())
                .hasSize(2)
                .allSatisfy(
                        problem ->
                                assertThat(problem.toString())
                                        .contains("revision 99 of the simulation", "is kept"));
        shelf.keep(wasteful);
        assertThat(read(shelf.best())).isEqualTo(wasteful);
        assertThat(read(shelf.last())).isEqualTo(wasteful);
        assertThat(shelf.ofOtherRevisions()).isEmpty();
        for (String name : List.of("drop.best", "drop.last")) {
            Path kept = shelf.best().resolveSibling(name + ".revision-99" + ReplayShelf.ENDING);
            assertThat(kept).hasContent(other);
        }
    }

    @Test
    void whereNothingIsKeptNothingCanBeWatched() {
        assertThat(shelf.watchable()).isEmpty();
    }
}

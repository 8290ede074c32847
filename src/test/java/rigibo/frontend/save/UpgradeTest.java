package rigibo.frontend.save;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.replay.LoadedReplay;
import rigibo.frontend.puzzle.replay.Proof;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.ReplayLoader;
import rigibo.frontend.puzzle.replay.ReplayShelf;
import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.LevelProgress;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Files written by builds of 0.1.0-SNAPSHOT can be read. Each folder of {@code rigibo/upgrade} is a
 * player's home as the build of that day left it, with the levels of that day: of the 22nd before
 * replays said their revision, of the 27th before there were days, stars and totals, of the 28th
 * the last before 0.2.0.
 */
class UpgradeTest {

    private static final Path HOMES =
            Path.of(System.getProperty("rigibo.home", ""), "src/test/resources/rigibo/upgrade");

    private static final String FIRST = "2026-11-22";
    private static final String SECOND = "2026-11-27";
    private static final String LAST = "2026-11-28";

    private static final int MOST_STEPS = 3600;

    @TempDir private Path temporary;
    private Path home;

    @BeforeEach
    void choosePlace() {
        home = temporary.resolve("home");
    }

    private void bring(String day) throws IOException {
        for (Path file : files(HOMES.resolve(day))) {
            Path copy = home.resolve(HOMES.resolve(day).relativize(file));
            Files.createDirectories(copy.getParent());
            Files.copy(file, copy);
        }
    }

    private static List<Path> files(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).sorted().toList();
        }
    }

    private List<Level> levels() throws IOException {
        List<Level> levels = new ArrayList<>();
        for (Path file : files(home.resolve("levels"))) {
            LoadedLevel loaded = new LevelLoader().load(file);
            assertThat(loaded.problems()).as("%s", file).noneMatch(Problem::isError);
            levels.add(loaded.level().orElseThrow());
        }
        return levels;
    }

    @ParameterizedTest
    @ValueSource(strings = {FIRST, SECOND, LAST})
    void solvedLevelsStaySolvedByTheHashOfTheirFile(String day) throws IOException {
        bring(day);
        try (SavedPlayer player = new SavedPlayer(Places.in(home), "en")) {
            assertThat(levels())
                    .hasSizeGreaterThan(1)
                    .allSatisfy(
                            level -> {
                                LevelProgress done = player.progress().of(level.id(), level.hash());
                                assertThat(done.isSolved()).isTrue();
                                assertThat(done.fewestClicks())
                                        .hasValue(level.solutions().get(0).clicks().size());
                            });
            assertThat(player.notices(new Words("en"))).isEmpty();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {FIRST, SECOND, LAST})
    void settingsStayAndNewOnesAreAsAtFirst(String day) throws IOException {
        bring(day);
        try (SavedPlayer player = new SavedPlayer(Places.in(home), "en")) {
            Settings settings = player.settings();
            assertThat(settings.language()).isEqualTo("de");
            assertThat(settings.volume()).isEqualTo(0.25);
            assertThat(settings.isMuted()).isTrue();
            assertThat(settings.motion()).isEqualTo(Settings.Motion.REDUCED);
            Settings first = Settings.initial("de");
            boolean isLast = day.equals(LAST);
            assertThat(settings.music()).isEqualTo(isLast ? 0.15 : first.music());
            assertThat(settings.text())
                    .isEqualTo(isLast ? Settings.TextSize.LARGEST : first.text());
            assertThat(settings.keys().of(Action.RESTART))
                    .isEqualTo(isLast ? Key.X : first.keys().of(Action.RESTART));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = LAST)
    void starsDaysAndTotalsStay(String day) throws IOException {
        bring(day);
        try (SavedPlayer player = new SavedPlayer(Places.in(home), "en")) {
            assertThat(player.progress().levels().get("two-storeys").hasStar()).isTrue();
            assertThat(player.progress().days()).containsKey(LocalDate.of(2026, 11, 27));
            assertThat(player.progress().endless()).isEqualTo(4);
            assertThat(player.progress().totals().clicks()).isEqualTo(21);
        }
    }

    /** It says by which version, and that nothing is lost. */
    @ParameterizedTest
    @ValueSource(strings = {FIRST, SECOND})
    void aRunOfAnotherRevisionIsToldAndKept(String day) throws IOException {
        bring(day);
        for (Level level : levels()) {
            ReplayShelf shelf = new ReplayShelf(home.resolve("replays"), level);
            assertThat(shelf.ofOtherRevisions())
                    .hasSize(2)
                    .allSatisfy(
                            problem ->
                                    assertThat(problem.toString())
                                            .contains(
                                                    ", by RigiBo 0.1.0-SNAPSHOT; this is revision",
                                                    "it is kept, and not played"));
            byte[] before = Files.readAllBytes(shelf.best());
            shelf.keep(Recording.of(level, level.solutions().get(0), Accuracy.GAME, MOST_STEPS));
            assertThat(shelf.ofOtherRevisions()).isEmpty();
            String aside = level.id() + ".best.revision-";
            assertThat(files(home.resolve("replays")))
                    .filteredOn(file -> file.getFileName().toString().startsWith(aside))
                    .singleElement()
                    .satisfies(file -> assertThat(file).hasBinaryContent(before));
        }
    }

    /** The revision decides, not the version: until it changes, runs of 0.1.0 play. */
    @ParameterizedTest
    @ValueSource(strings = LAST)
    void aRunOfThisRevisionPlaysToTheSameBits(String day) throws IOException {
        bring(day);
        for (Level level : levels()) {
            Path file = new ReplayShelf(home.resolve("replays"), level).best();
            LoadedReplay loaded = new ReplayLoader(List.of(level)).load(file);
            assumeTrue(loaded.otherRevision().isEmpty(), "it is of another revision by now");
            assertThat(Proof.of(loaded.recording().orElseThrow()).isSame()).isTrue();
        }
    }
}

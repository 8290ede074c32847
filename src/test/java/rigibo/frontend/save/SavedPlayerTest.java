package rigibo.frontend.save;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.DayResult;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Totals;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.List;
import java.util.stream.Stream;

/** Whatever happens to the files, no data of the player is lost silently. */
class SavedPlayerTest {

    private static final Progress ONE = Progress.none().solved("tilt", 7, 2);
    private static final Progress TWO =
            ONE.solved("seesaw", -1, 1)
                    .failed("tilt", 7)
                    .starred("tilt", 7)
                    .solvedDay(LocalDate.of(2026, 11, 27), new DayResult(2, 900))
                    .endless(12)
                    .played(new Totals(3, 7, 5000));

    @TempDir Path folder;

    private SavedPlayer start() {
        return new SavedPlayer(Places.in(folder), "de");
    }

    private void play(Progress done) {
        try (SavedPlayer player = start()) {
            player.progress(done);
        }
    }

    private Path file(String name) {
        return folder.resolve(name);
    }

    private static List<String> notices(SavedPlayer player) {
        return player.notices(new Words("en"));
    }

    /** All but the lock, which stays: to delete it would be to let two games lock two files. */
    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(path -> path.getFileName().toString())
                    .filter(name -> !name.equals(".lock"))
                    .sorted()
                    .toList();
        }
    }

    @Test
    void startsAsCalmAsTheSystemIsUntilThePlayerChooses() {
        Settings calm = Settings.initial("en").withMotion(Settings.Motion.REDUCED);
        try (SavedPlayer player = new SavedPlayer(Places.in(folder), calm)) {
            assertThat(player.settings().motion()).isEqualTo(Settings.Motion.REDUCED);
            player.settings(player.settings().withMotion(Settings.Motion.FULL));
        }
        try (SavedPlayer player = new SavedPlayer(Places.in(folder), calm)) {
            assertThat(player.settings().motion()).isEqualTo(Settings.Motion.FULL);
        }
    }

    @Test
    void startsInTheSystemsLanguageWithoutAWord() throws IOException {
        try (SavedPlayer player = start()) {
            assertThat(player.settings()).isEqualTo(Settings.initial("de"));
            assertThat(player.progress()).isEqualTo(Progress.none());
            assertThat(notices(player)).isEmpty();
        }
        assertThat(names()).as("nothing was chosen, nothing is written").isEmpty();
    }

    @Test
    void remembersEverySettingAndAllProgress() {
        Settings chosen =
                Settings.initial("en")
                        .withVolume(0.25)
                        .withMuted(true)
                        .withMotion(Settings.Motion.REDUCED)
                        .withDetail(Settings.Detail.LITE)
                        .withFullScreen(true)
                        .withGhost(true)
                        .withMusic(0.15)
                        .withText(Settings.TextSize.LARGEST)
                        .withKeys(KeyBindings.FIRST.with(Action.RESTART, Key.X).orElseThrow());
        try (SavedPlayer player = start()) {
            player.settings(chosen);
            player.progress(TWO);
        }
        try (SavedPlayer player = start()) {
            assertThat(player.settings()).isEqualTo(chosen);
            assertThat(player.progress()).isEqualTo(TWO);
            assertThat(notices(player)).isEmpty();
        }
    }

    @Test
    void readsProgressFromBeforeThereWereLevelsOfDays() throws IOException {
        String before =
                "{\"format\": 1, \"levels\": {\"tilt\": {\"hash\": \"7\", \"solved\": true,"
                        + " \"fewestClicks\": 2, \"failures\": 0}}}";
        Files.writeString(file("progress.json"), before);
        try (SavedPlayer player = start()) {
            assertThat(player.progress()).isEqualTo(Progress.none().solved("tilt", 7, 2));
            assertThat(notices(player)).isEmpty();
        }
    }

    @Test
    void keepsTheFileBeforeAndLeavesNothingElse() throws IOException {
        play(ONE);
        byte[] first = Files.readAllBytes(file("progress.json"));
        play(TWO);
        assertThat(names()).containsExactly("progress.json", "progress.json.backup");
        assertThat(file("progress.json.backup")).hasBinaryContent(first);
    }

    @Test
    void goesOnFromTheBackupWhenThePowerFailedBetweenTwoMoves() throws IOException {
        play(ONE);
        Files.move(file("progress.json"), file("progress.json.backup"));
        try (SavedPlayer player = start()) {
            assertThat(player.progress()).isEqualTo(ONE);
            assertThat(notices(player)).isEmpty();
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "\0\0\0\0",
                "{\"format\": 1, \"levels\": {\"tilt\"",
                "[]",
                "17",
                "{}",
                "{\"format\": \"one\"}",
                "{\"format\": 1}",
                "{\"format\": 1, \"levels\": []}",
                "{\"format\": 1, \"levels\": {\"tilt\": 3}}",
                "{\"format\": 1, \"levels\": {\"tilt\": {\"hash\": \"xyz\", \"solved\": true,"
                        + " \"failures\": 0}}}",
                "{\"format\": 1, \"levels\": {\"tilt\": {\"hash\": \"7\", \"solved\": true,"
                        + " \"failures\": -3}}}",
                "{\"format\": 1, \"levels\": {}, \"days\": []}",
                "{\"format\": 1, \"levels\": {}, \"days\": {\"2026-02-30\": {\"clicks\": 2,"
                        + " \"steps\": 900}}}",
                "{\"format\": 1, \"levels\": {}, \"days\": {\"2026-11-27\": {\"clicks\": 0,"
                        + " \"steps\": 900}}}",
                "{\"format\": 1, \"levels\": {}, \"endless\": 0}",
                "{\"format\": 1, \"levels\": {}} and more"
            })
    void setsADamagedFileAsideAndUsesTheBackup(String damage) throws IOException {
        play(ONE);
        play(TWO);
        Files.writeString(file("progress.json"), damage);
        try (SavedPlayer player = start()) {
            assertThat(player.progress()).isEqualTo(ONE);
            assertThat(notices(player)).singleElement().asString().contains("progress.json");
            player.progress(TWO);
        }
        assertThat(file("progress.json.damaged-1")).hasContent(damage);
        try (SavedPlayer player = start()) {
            assertThat(player.progress()).isEqualTo(TWO);
            assertThat(notices(player)).isEmpty();
        }
    }

    @Test
    void setsEveryDamagedFileAsideUnderANameOfItsOwn() throws IOException {
        for (String damage : List.of("first", "second")) {
            Files.writeString(file("progress.json"), damage);
            start().close();
        }
        assertThat(file("progress.json.damaged-1")).hasContent("first");
        assertThat(file("progress.json.damaged-2")).hasContent("second");
    }

    @Test
    void startsAnewWithAWordWhenTheBackupIsDamagedToo() throws IOException {
        Files.writeString(file("progress.json"), "broken");
        Files.writeString(file("progress.json.backup"), "broken, too");
        try (SavedPlayer player = start()) {
            assertThat(player.progress()).isEqualTo(Progress.none());
            assertThat(notices(player)).hasSize(1);
            player.forgetNotices();
            assertThat(notices(player)).isEmpty();
        }
        assertThat(names())
                .containsExactly("progress.json.backup.damaged-1", "progress.json.damaged-1");
    }

    @ParameterizedTest
    @ValueSource(strings = {"progress.json", "progress.json.backup"})
    void leavesAFileOfANewerGameAlone(String name) throws IOException {
        String newer = "{\"format\": 2, \"levels\": \"who knows\"}";
        Files.writeString(file(name), newer);
        try (SavedPlayer player = start()) {
            player.progress(ONE);
            assertThat(player.progress()).isEqualTo(ONE);
        }
        assertThat(file(name)).hasContent(newer);
        assertThat(names()).containsExactly(name);
    }

    @Test
    void tellsOfAFileOfANewerGame() throws IOException {
        Files.writeString(file("settings.json"), "{\"format\": 99}");
        try (SavedPlayer player = start()) {
            assertThat(player.settings()).isEqualTo(Settings.initial("de"));
            assertThat(notices(player)).singleElement().asString().contains("newer");
        }
    }

    @Test
    void settingsThatAnOlderGameDidNotKnowAreAsAtFirst() throws IOException {
        Files.writeString(file("settings.json"), "{\"format\": 1, \"volume\": 0.5}");
        try (SavedPlayer player = start()) {
            assertThat(player.settings()).isEqualTo(Settings.initial("de").withVolume(0.5));
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"format\": 1, \"volume\": 7}",
                "{\"format\": 1, \"volume\": \"loud\"}",
                "{\"format\": 1, \"language\": \"tlh\"}",
                "{\"format\": 1, \"language\": null}",
                "{\"format\": 1, \"motion\": null}",
                "{\"format\": 1, \"detail\": null}",
                "{\"format\": 1e308}",
                "{\"format\": 1, \"motion\": \"wild\"}",
                "{\"format\": 1, \"text\": \"tiny\"}",
                "{\"format\": 1, \"keys\": 3}",
                "{\"format\": 1, \"keys\": {\"pause\": \"enter\"}}",
                "{\"format\": 1, \"keys\": {\"pause\": \"x\", \"undo\": \"x\"}}"
            })
    void settingsThatCannotBeAreDamaged(String damage) throws IOException {
        Files.writeString(file("settings.json"), damage);
        try (SavedPlayer player = start()) {
            assertThat(player.settings()).isEqualTo(Settings.initial("de"));
            assertThat(notices(player)).hasSize(1);
        }
        assertThat(file("settings.json.damaged-1")).hasContent(damage);
    }

    /**
     * A path that is as long as Linux takes, so that no longer name has room in its folder, stands
     * for a folder that cannot be written.
     */
    @Test
    void aDamagedFileThatCannotBeMovedIsNotSaidToBeSetAside() throws IOException {
        assumeThat(Path.of("/proc/self")).exists();
        int most = 4095 - "/settings.json".length();
        Path deep = folder;
        while (most - deep.toString().length() > 1) {
            int room = Math.min(200, most - deep.toString().length() - 1);
            deep = deep.resolve("d".repeat(room));
        }
        Files.createDirectories(deep);
        Path damaged = Files.writeString(deep.resolve("settings.json"), "broken");
        try (SavedPlayer player = new SavedPlayer(Places.in(deep), "en")) {
            assertThat(notices(player)).first().asString().contains("could not be set aside");
            assertThat(notices(player)).noneMatch(notice -> notice.contains("was set aside"));
            assertThat(player.settings()).isEqualTo(Settings.initial("en"));
        }
        assertThat(damaged).hasContent("broken");
    }

    @Test
    void aDamagedBackupWithoutItsFileIsToldOf() throws IOException {
        Files.writeString(file("progress.json.backup"), "broken");
        try (SavedPlayer player = start()) {
            assertThat(notices(player)).singleElement().asString().contains("set aside");
        }
        assertThat(file("progress.json.backup.damaged-1")).hasContent("broken");
    }

    /** A file where the folder should be stands for a disk that cannot be written. */
    @Test
    void goesOnInMemoryWhereNothingCanBeWrittenAndTriesAgain() throws IOException {
        Path home = folder.resolve("home");
        try (SavedPlayer player = new SavedPlayer(Places.in(home), "en")) {
            Files.writeString(home, "in the way");
            player.progress(ONE);
            player.save();
            assertThat(player.progress()).isEqualTo(ONE);
            assertThat(notices(player)).singleElement().asString().contains("try again");
            player.forgetNotices();
            assertThat(notices(player)).as("it still holds").hasSize(1);

            Files.delete(home);
            player.save();
            assertThat(notices(player)).isEmpty();
        }
        try (SavedPlayer player = new SavedPlayer(Places.in(home), "en")) {
            assertThat(player.progress()).isEqualTo(ONE);
        }
    }

    @Test
    void whatCannotBeReadStaysAndIsToldOf() throws IOException {
        Path inTheWay = Files.createDirectories(file("progress.json").resolve("not a file"));
        try (SavedPlayer player = start()) {
            assertThat(notices(player)).singleElement().asString().contains("cannot be read");
            player.progress(ONE);
        }
        assertThat(inTheWay).exists();
        assertThat(names()).containsExactly("progress.json");
    }

    /** Under Linux a device that takes nothing stands for a disk that is full. */
    @Test
    void aFullDiskLeavesTheOldFileAsItWas() throws IOException {
        Path full = Path.of("/dev/full");
        assumeThat(full).exists();
        play(ONE);
        byte[] before = Files.readAllBytes(file("progress.json"));
        Path halfWritten = file("progress.json." + ProcessHandle.current().pid());
        try (SavedPlayer player = start()) {
            Files.createSymbolicLink(halfWritten, full);
            player.progress(TWO);
            player.save();
            assertThat(notices(player)).hasSize(1);
            assertThat(file("progress.json")).hasBinaryContent(before);
            assertThat(names()).containsExactly("progress.json");
            player.save();
            assertThat(notices(player)).isEmpty();
        }
    }

    @Test
    void twoGamesAtOnceKeepWhatWasDoneInEither() {
        try (SavedPlayer one = start();
                SavedPlayer other = start()) {
            one.progress(Progress.none().solved("tilt", 7, 3).solved("seesaw", 9, 1));
            one.save();
            other.progress(Progress.none().solved("tilt", 7, 2).failed("arch", 5));
            other.save();
        }
        try (SavedPlayer player = start()) {
            assertThat(player.progress())
                    .isEqualTo(
                            Progress.none()
                                    .solved("tilt", 7, 2)
                                    .solved("seesaw", 9, 1)
                                    .failed("arch", 5));
        }
    }
}

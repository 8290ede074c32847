package rigibo.frontend.save;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/** Games in processes of their own that share a home. */
class TwoGamesTest {

    /** Times that both save at the same moment: without a lock about every other one loses. */
    private static final int ROUNDS = 10;

    @TempDir Path home;

    private Progress kept() {
        try (SavedPlayer player = new SavedPlayer(Places.in(home), "en")) {
            assertThat(player.notices(new Words("en"))).isEmpty();
            return player.progress();
        }
    }

    @Test
    void whatTwoGamesSolveAtTheSameMomentIsKeptOfBoth() throws Exception {
        try (OtherGame one = OtherGame.on(home);
                OtherGame other = OtherGame.on(home)) {
            for (int round = 0; round < ROUNDS; round++) {
                one.tell("solve one-" + round);
                other.tell("solve other-" + round);
                one.done();
                other.done();
                // Asked now: the next save of each would mend what this one lost.
                assertThat(kept().levels())
                        .as("round %d", round)
                        .hasSize(2 * (round + 1))
                        .containsKeys("one-" + round, "other-" + round);
            }
        }
    }

    @Test
    void aSettingChosenInOneGameOutlivesAnotherChosenInTheOther() throws Exception {
        Settings chosen = Settings.initial("en").withVolume(0.25).withMuted(true);
        try (SavedPlayer one = new SavedPlayer(Places.in(home), "en");
                OtherGame other = OtherGame.on(home)) {
            other.tell("volume 0.25");
            other.done();
            one.settings(one.settings().withMuted(true));
        }
        try (SavedPlayer player = new SavedPlayer(Places.in(home), "en")) {
            assertThat(player.settings()).isEqualTo(chosen);
        }
    }

    @Test
    void whatAKilledGameLeftHalfWrittenIsSweptAtTheNextStart() throws Exception {
        List<Path> left;
        try (OtherGame game = OtherGame.on(home)) {
            left =
                    List.of(
                            begun(game, "progress.json"),
                            begun(game, "settings.json"),
                            begun(game, "replays/tilt.best.replay.json"),
                            begun(game, "levels/mine.json"),
                            begun(game, "levels/unsaved/1.unsaved.json"));
            assertThat(kept()).isEqualTo(Progress.none());
            assertThat(left).as("it lives, and may go on writing").allMatch(Files::exists);
        }
        kept();
        assertThat(left).noneMatch(Files::exists);
    }

    private Path begun(OtherGame game, String file) throws IOException {
        game.tell("begin " + file);
        game.done();
        return home.resolve(file + "." + game.pid());
    }

    @Test
    void filesWithOtherNamesAreNotSwept() throws IOException {
        // No process has the number 999999999: systems count to 2²² at most.
        List<String> names = List.of("progress.json.old", "notes.999999999", "progress.json.1.txt");
        for (String name : names) {
            Files.writeString(home.resolve(name), "the player's");
        }
        kept();
        assertThat(names).allMatch(name -> Files.exists(home.resolve(name)));
    }

    @Test
    void aLockWhoseHolderWasKilledHoldsNobodyUp() throws Exception {
        FolderLock lock = new FolderLock(home, Duration.ZERO);
        try (OtherGame holder = OtherGame.on(home)) {
            holder.tell("hold");
            holder.done();
            assertThat(lock.during(() -> {})).isFalse();
        }
        assertThat(lock.during(() -> {})).isTrue();
    }

    /** As one does that is stopped, or that a debugger holds. */
    @Test
    void aHolderThatNeverGoesOnDoesNotKeepOthersFromSaving() throws Exception {
        try (OtherGame holder = OtherGame.on(home)) {
            holder.tell("hold");
            holder.done();
            AtomicInteger saved = new AtomicInteger();
            new FolderLock(home, Duration.ofMillis(20)).during(saved::incrementAndGet);
            assertThat(saved).hasValue(1);
        }
    }

    @Test
    void aFileSystemWithoutLocksIsToldOnceAndSavedTo() throws IOException {
        FolderLock none =
                new FolderLock(
                        home,
                        Duration.ZERO,
                        channel -> {
                            throw new IOException("No locks available");
                        });
        Kept<Progress> progress =
                new Kept<>(home.resolve("progress.json"), new ProgressFormat(), none);
        for (int clicks = 3; clicks > 0; clicks--) {
            progress.value(Progress.none().solved("tilt", 7, clicks));
            assertThat(progress.save()).isTrue();
        }
        assertThat(progress.notices())
                .singleElement()
                .extracting(Notice::kind)
                .isEqualTo(Notice.Kind.UNLOCKED);
        assertThat(kept()).isEqualTo(Progress.none().solved("tilt", 7, 1));
    }
}

package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.click;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.document.Problems;
import rigibo.frontend.document.ShareCode;
import rigibo.frontend.puzzle.endless.Day;
import rigibo.frontend.puzzle.endless.Endless;
import rigibo.frontend.puzzle.endless.Making;
import rigibo.frontend.puzzle.endless.Occasion;
import rigibo.frontend.puzzle.generate.Generator;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Origin;
import rigibo.frontend.puzzle.record.Tally;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.Recordings;
import rigibo.frontend.puzzle.replay.ReplayCode;
import rigibo.frontend.puzzle.replay.UnmadeReplay;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.Replay;
import rigibo.frontend.scene.DayResult;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Plate;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

import java.time.Clock;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.List;
import java.util.Optional;

/** Levels of days and endless ones, from the list to the result. */
class MadeLevelsTest {

    private static final LocalDate DATE = LocalDate.of(2026, 11, 27);

    /** Seeds of which none has a level: there are none. */
    private static final List<Long> NO_SEEDS = List.of();

    private static final Endless FIRST = new Endless(1);

    /** The first endless level, made once for all tests here. */
    private static Making done;

    private final RecordingDirector director = new RecordingDirector();

    @BeforeAll
    static void make() throws InterruptedException {
        done = Making.begin(FIRST.seeds());
        done.await();
    }

    private Scene last() {
        return director.shown.get(director.shown.size() - 1);
    }

    /** Plays the stored solution and reports it as the scene of the level does. */
    private void solve(Occasion occasion) {
        Level level = done.made().orElseThrow().level();
        Replay solution = Replay.of(level, level.solutions().get(0), Accuracy.GAME);
        Playback playback = new Playback(level, solution);
        while (playback.game().outcome() == Outcome.RUNNING) {
            playback.step();
        }
        assertThat(playback.game().outcome()).isEqualTo(Outcome.WON);
        new Tally(director, level, occasion.ledger(director, level)).ended(playback.game());
    }

    @Test
    void dayIsThatOfUniversalTimeWhereverTheClockStands() {
        Instant late = Instant.parse("2026-11-27T23:30:00Z");
        for (String zone : List.of("UTC", "Pacific/Auckland", "America/Los_Angeles")) {
            assertThat(Day.of(Clock.fixed(late, ZoneId.of(zone)))).isEqualTo(new Day(DATE));
        }
    }

    @Test
    void seedsOfADayAreItsDateAndNoneIsThatOfAnotherDay() {
        assertThat(new Day(DATE).seeds()).startsWith(20261127L).doesNotHaveDuplicates();
        assertThat(new Day(DATE).seeds())
                .doesNotContainAnyElementsOf(new Day(DATE.plusDays(1)).seeds());
    }

    @Test
    void everySeedOfADayTellsIt() {
        Day leap = new Day(LocalDate.of(2028, 2, 29));
        assertThat(leap.seeds()).allMatch(seed -> Day.ofSeed(seed).equals(Optional.of(leap)));
    }

    /** Endless levels, invalid dates, and a number beyond the seeds of a day. */
    @ParameterizedTest
    @ValueSource(longs = {-1, 1, 10_115, 19_991_231, 20_270_229, 20_261_300, 1_020_261_127})
    void otherSeedsAreNoDay(long seed) {
        assertThat(Day.ofSeed(seed)).isEmpty();
    }

    @Test
    void datesAreWrittenAsInThePlayersLanguage() {
        Day day = new Day(DATE);
        assertThat(day.title(new Words("en"))).isEqualTo("Level of the day, 2026-11-27");
        assertThat(day.title(new Words("de"))).isEqualTo("Level des Tages, 27.11.2026");
    }

    @Test
    void bestGameOfADayIsKept() {
        Day day = new Day(DATE);
        solve(day);
        DayResult result = director.progress().days().get(DATE);
        assertThat(result.clicks()).isEqualTo(done.made().orElseThrow().level().limits().par());
        assertThat(director.progress().levels()).isEmpty();
        List<String> shown = day.results(director).get(0);
        assertThat(shown).startsWith("2026-11-27");
    }

    @Test
    void solvedEndlessLevelLeadsToTheNext() {
        solve(FIRST);
        assertThat(director.progress().endless()).isEqualTo(2);
        assertThat(director.progress().levels()).isEmpty();
    }

    @Test
    void levelThatIsDoneIsShownAndPlayed() {
        MadeLevelScene scene = new MadeLevelScene(director, FIRST, done);
        scene.step();
        click(scene, "Play");
        assertThat(last()).isInstanceOf(PuzzleScene.class);
        assertThat(last().title()).isEqualTo("RigiBo – No. 1");
        last().closed();
    }

    @Test
    void buttonsAreAsLargeAsAFingerInAHand() {
        for (Layout layout : Legibility.HANDS) {
            MadePlaces places = MadePlaces.of(layout);
            for (Plate button : List.of(places.back(), places.button(0, 2), places.button(1, 2))) {
                assertThat(button.height() * layout.ratio()).isGreaterThanOrEqualTo(43.9);
                assertThat(button.width() * layout.ratio()).isGreaterThanOrEqualTo(43.9);
                assertThat(button.right()).isLessThanOrEqualTo(layout.seenRight());
            }
            assertThat(places.results().y()).isGreaterThanOrEqualTo(places.play().bottom());
            assertThat(places.rows()).isNotNegative();
        }
    }

    @Test
    void anotherEndlessLevelCanBeChosenUnsolved() {
        MadeLevelScene scene = new MadeLevelScene(director, FIRST, done);
        click(scene, "Another one");
        assertThat(director.progress().endless()).isEqualTo(2);
        assertThat(last()).isInstanceOf(MadeLevelScene.class);
        last().closed();
    }

    @Test
    void enterLeadsNowhereWhileALevelIsMade() {
        MadeLevelScene scene = new MadeLevelScene(director, FIRST);
        scene.keyPressed(Key.ENTER);
        scene.keyPressed(Key.LEFT);
        assertThat(director.asked).isEmpty();
        scene.keyPressed(Key.ENTER);
        assertThat(director.asked).containsExactly("levels");
        scene.closed();
    }

    @Test
    void stoppedMakingMakesNothing() throws InterruptedException {
        Making making = Making.begin(FIRST.seeds());
        making.stop();
        making.await();
        assertThat(making.made()).isEmpty();
        assertThat(making.isHopeless()).isFalse();
    }

    @ParameterizedTest
    @CsvSource({"en, 'Draft 1, tried out '", "de, 'Entwurf 1, '"})
    void whoWaitsReadsHowFarItIs(String language, String words) throws InterruptedException {
        RecordingDirector told = new RecordingDirector(language);
        Making making = Making.begin(FIRST.seeds());
        while (making.effort().isEmpty()) {
            Thread.sleep(1);
        }
        making.stop();
        making.await();
        MadeLevelScene scene = new MadeLevelScene(told, FIRST, making);
        assertThat(RecordingCanvas.of(scene).texts()).anyMatch(text -> text.startsWith(words));
        assertThat(Legibility.faults(scene)).isEmpty();
        assertThat(Legibility.faultsInHand(scene)).isEmpty();
    }

    @Test
    void seedsWithoutALevelAreToldOf() throws InterruptedException {
        Making making = Making.begin(NO_SEEDS);
        making.await();
        MadeLevelScene scene = new MadeLevelScene(director, FIRST, making);
        assertThat(RecordingCanvas.of(scene).texts()).contains("No level could be made");
        scene.step();
        scene.keyPressed(Key.ENTER);
        assertThat(director.asked).containsExactly("levels");
    }

    private static JsonNode replay() {
        return replayOf(done);
    }

    private static JsonNode replayOf(Making making) {
        Level level = making.made().orElseThrow().level();
        Recording run = Recordings.of(level.called("mine", level.title()), Accuracy.GAME);
        String code = ReplayCode.of(run).orElseThrow();
        String text = ShareCode.read(code, new Problems("code")).orElseThrow().text();
        return JsonMapper.shared().readTree(text);
    }

    private Scene pasted(JsonNode replay) {
        String code = ShareCode.of(ShareCode.Kind.REPLAY, replay).orElseThrow();
        return PlayerFiles.pasted(director, code).orElseThrow();
    }

    private MadeReplayScene waiting(JsonNode replay, Making making) {
        Origin origin = making.made().or(done::made).orElseThrow().level().origin().orElseThrow();
        return new MadeReplayScene(
                director, new UnmadeReplay("code", replay.toString(), origin), making);
    }

    /** The receiver has neither the level nor its name, only its origin. */
    @Test
    void replayOfAMadeLevelIsWatchedOnceItsLevelIsMade() {
        Scene scene = pasted(replay());
        assertThat(scene).isInstanceOf(MadeReplayScene.class);
        scene.step();
        assertThat(RecordingCanvas.of(scene).texts()).contains("The level is being made");
        scene.closed();
        waiting(replay(), done).step();
        assertThat(last()).isInstanceOf(ReplayScene.class);
        Demonstration show = last().demonstration().orElseThrow();
        for (int turn = 0; turn < 3600 && !show.isOver(); turn++) {
            last().step();
        }
        assertThat(show.hasSucceeded()).as("the same to the last bit").isTrue();
    }

    @Test
    void replayOfADayIsCalledAfterTheDay() throws InterruptedException {
        Making making = Making.begin(new Day(DATE).seeds());
        making.await();
        waiting(replayOf(making), making).step();
        assertThat(last().title()).contains("Level of the day, 2026-11-27");
        last().closed();
    }

    @Test
    void replayOfAnotherGeneratorIsToldAndNotPlayedInAnotherLevel() {
        JsonNode other = replay();
        ((ObjectNode) other.at("/level/made")).put("generator", Generator.VERSION + 1);
        assertThat(String.join(" ", RecordingCanvas.of(pasted(other)).texts()))
                .contains("It is of another version");
    }

    @Test
    void replayOfALevelThatIsMadeOtherwiseIsRefused() {
        JsonNode altered = replay();
        ((ObjectNode) altered.at("/level")).put("hash", "0123456789abcdef");
        waiting(altered, done).step();
        assertThat(String.join(" ", RecordingCanvas.of(last()).texts()))
                .contains("It is a run of a level that was changed since.");
    }

    @Test
    void replayWithAnUnsoundSeedIsRefusedAtOnce() {
        JsonNode unsound = replay();
        ((ObjectNode) unsound.at("/level/made")).put("seed", -1);
        assertThat(pasted(unsound)).isInstanceOf(ProblemsScene.class);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void waitingForALevelCanBeRead(String language) throws InterruptedException {
        director.settings(director.settings().withLanguage(language));
        Making hopeless = Making.begin(NO_SEEDS);
        hopeless.await();
        MadeReplayScene scene = waiting(replay(), hopeless);
        assertThat(Legibility.faultsInHand(scene)).isEmpty();
        assertThat(Legibility.faults(scene)).isEmpty();
        scene.step();
        scene.keyPressed(Key.ENTER);
        assertThat(director.asked).containsExactly("levels");
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void everythingCanBeRead(String language) {
        RecordingDirector told = new RecordingDirector(language);
        for (int day = 0; day < 20; day++) {
            DayResult result = new DayResult(2 + day % 4, 1000 + day);
            told.progress(told.progress().solvedDay(DATE.minusDays(day), result));
        }
        MadeLevelScene ready = new MadeLevelScene(told, new Day(DATE), done);
        ready.step();
        assertThat(Legibility.faults(ready)).isEmpty();
        assertThat(Legibility.faultsInHand(ready)).isEmpty();
        MadeLevelScene endless = new MadeLevelScene(told, FIRST, done);
        endless.step();
        assertThat(Legibility.faults(endless)).isEmpty();
        assertThat(Legibility.faultsInHand(endless)).isEmpty();
        MadeLevelScene waiting = new MadeLevelScene(told, FIRST);
        assertThat(Legibility.faults(waiting)).isEmpty();
        waiting.closed();
    }
}

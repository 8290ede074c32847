package rigibo.frontend.puzzle.hud;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.puzzle.PlayedLevel;
import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.VerbLevels;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Settings.Motion;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** A hand shows the first click; the first level explains cooldown, clicks and hold. */
class LessonTest {

    private static final double SCALE = 80;

    /** Distance from the tip of the finger to the beginning of its line, px. */
    private static final double NAIL = 4;

    private static final Level ROPE =
            VerbLevels.of(
                    VerbLevels.ROPE
                            .replace(", \"deletable\": true", "")
                            .replaceFirst(
                                    "\\}\\s*$",
                                    ", \"solutions\": [{\"clicks\": [{\"t\": 1, \"joint\":"
                                            + " \"line\"}]}]}"));

    private static List<RecordingCanvas.Line> hand(PlayedLevel played) {
        return played.canvas().lines().stream()
                .filter(line -> line.color().equals(Color.TEXT))
                .toList();
    }

    /** The finger comes to the middle of the rope, which hangs from 8 m to 5 m at x = 2 m. */
    @Test
    void theHandComesToWhatIsToBeClicked() {
        PlayedLevel played = new PlayedLevel(ROPE);
        assertThat(hand(played)).as("at first").isEmpty();
        played.turns(48);
        double far = Math.hypot(tip(played)[0] - 160, tip(played)[1] - (800 - 6.5 * SCALE));
        assertThat(far).as("on its way").isGreaterThan(30);
        played.turns(60);
        assertThat(tip(played)[0]).isCloseTo(160, within(2.0));
        assertThat(tip(played)[1]).isCloseTo(800 - 6.5 * SCALE, within(6.0));
        assertThat(played.canvas().rings()).anyMatch(ring -> Math.abs(ring.x() - 160) < 2);
    }

    private static double[] tip(PlayedLevel played) {
        RecordingCanvas.Line finger = hand(played).get(0);
        return new double[] {finger.x1(), finger.y1() - NAIL};
    }

    @Test
    void whoWantsLessMotionSeesTheHandAtRest() {
        PlayedLevel played = new PlayedLevel(ROPE, "en", Motion.REDUCED);
        assertThat(tip(played)[0]).isCloseTo(160, within(2.0));
        double before = tip(played)[1];
        assertThat(tip(played.turns(1))[1]).isCloseTo(before, within(0.5));
    }

    @Test
    void theHandGoesWithTheFirstClick() {
        PlayedLevel played = new PlayedLevel(ROPE).turns(100);
        assertThat(hand(played)).isNotEmpty();
        played.click(2, 6.2).turns(1);
        assertThat(hand(played)).isEmpty();
    }

    /** Only the first level with a verb teaches it, and only until it is solved. */
    @ParameterizedTest
    @CsvSource({"0, false, true", "0, true, false", "1, false, false"})
    void nobodyIsTaughtTwice(int number, boolean isSolved, boolean isTaught) {
        Lesson lesson = Lesson.of(List.of(ROPE, ROPE), number, isSolved);
        RecordingCanvas canvas = new RecordingCanvas();
        Session session = new Session(ROPE, Accuracy.GAME);
        lesson.draw(canvas, session, new View(ROPE).camera(), Motion.REDUCED);
        assertThat(canvas.lines().isEmpty()).isNotEqualTo(isTaught);
    }

    /** The level's first solution begins with freezing, which is new; its gate is known. */
    @Test
    void aNewVerbBesideAKnownOneIsTaught() {
        List<Level> all = Levels.all();
        int number = all.stream().map(Level::id).toList().indexOf("set-in-stone");
        Level level = all.get(number);
        RecordingCanvas canvas = new RecordingCanvas();
        Lesson.of(all, number, false)
                .draw(
                        canvas,
                        new Session(level, Accuracy.GAME),
                        new View(level).camera(),
                        Motion.REDUCED);
        assertThat(canvas.lines()).isNotEmpty();
    }

    @Test
    void theBarExplainsCooldownAndHoldAsTheyHappen() {
        Lesson first = Lesson.of(List.of(ROPE, ROPE), 0, false);
        Lesson second = Lesson.of(List.of(ROPE, ROPE), 1, false);
        PuzzleGame game = new PuzzleGame(ROPE, Accuracy.GAME);
        assertThat(first.words(game)).isEmpty();
        game.act("line");
        game.step();
        assertThat(first.words(game)).contains("puzzle.lesson.cooldown");
        assertThat(second.words(game)).isEmpty();
        while (game.held() == 0) {
            game.step();
        }
        assertThat(first.words(game)).contains("puzzle.lesson.hold");
        assertThat(second.words(game)).isEmpty();
        while (game.held() < 1) {
            game.step();
        }
        assertThat(first.words(game)).as("it is solved").isEmpty();
    }

    /** In the first level of the game, in every language. */
    @ParameterizedTest
    @CsvSource({
        "en, next click when the ring is full, 'the fewer clicks, the better the medal',"
                + " keep it there until the ring is full",
        "de, 'Warte auf den vollen Ring', 'je weniger Klicks, desto besser',"
                + " 'Bleib bis zum vollen Ring'"
    })
    void theWordsFitIntoTheBar(String language, String cooldown, String par, String hold) {
        Set<String> seen = new HashSet<>();
        PlayedLevel played = new PlayedLevel(Levels.all().get(0), language, Motion.FULL);
        for (Click click : played.level.solutions().get(0).clicks()) {
            LevelBody body =
                    played.level.bodies().stream()
                            .filter(it -> it.id().equals(click.target()))
                            .findFirst()
                            .orElseThrow();
            played.turns(120).click(body.x(), body.y()).turns(1);
            assertThat(played.texts()).contains(cooldown);
            played.turns(61);
            assertThat(played.texts()).containsAnyOf(par, hold);
            seen.addAll(played.texts());
        }
        assertThat(seen).contains(par);
        for (int i = 0; i < PlayedLevel.LONG_ENOUGH && !played.texts().contains(hold); i++) {
            played.turns(1);
        }
        assertThat(played.texts()).contains(hold);
    }
}

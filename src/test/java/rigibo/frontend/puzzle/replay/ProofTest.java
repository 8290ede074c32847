package rigibo.frontend.puzzle.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ContactSolver;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.puzzle.rules.ClickResult;
import rigibo.frontend.puzzle.rules.Replay;
import rigibo.frontend.scene.Words;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

class ProofTest {

    private static final Words WORDS = new Words("en");

    static Stream<Level> levelsOfTheGame() {
        LevelLoader loader = new LevelLoader();
        return LevelShelf.files().stream().map(file -> loader.load(file).level().orElseThrow());
    }

    @ParameterizedTest
    @MethodSource("levelsOfTheGame")
    void whatWasWrittenAndReadPlaysBackTheSameToTheLastBit(Level level) {
        Recording played = Recordings.of(level, Accuracy.GAME);
        Recording read = read(played, level);
        assertThat(read).isEqualTo(played);
        Verdict verdict = Proof.of(read);
        assertThat(verdict)
                .isEqualTo(new Verdict.Same(played.checkpoints().size(), played.steps()));
        assertThat(verdict.in(WORDS)).startsWith("the same to the last bit: ");
    }

    @ParameterizedTest
    @MethodSource("accuracies")
    void everyKnobOfTheAccuracyIsKept(Accuracy accuracy) {
        Recording played = Recordings.of(LevelTexts.sound(), accuracy);
        Recording read = read(played, LevelTexts.sound());
        assertThat(read.replay().accuracy()).isEqualTo(accuracy);
        assertThat(Proof.of(read).isSame()).isTrue();
    }

    static Stream<Accuracy> accuracies() {
        return Stream.of(
                Accuracy.DRAFT,
                Accuracy.GAME.withImpactTolerance(Math.nextUp(1e-4)),
                Accuracy.EXACT,
                Accuracy.FINE
                        .withContactSolver(ContactSolver.SEQUENTIAL)
                        .withVelocityIterations(8));
    }

    private static Recording read(Recording played, Level level) {
        return new ReplayLoader(List.of(level))
                .parse("a.replay.json", ReplayText.of(played))
                .recording()
                .orElseThrow();
    }

    @Test
    void aChangedBitIsToldBetweenTheStatesRoundIt() {
        Recording played = Recordings.sound();
        List<Checkpoint> changed = new ArrayList<>(played.checkpoints());
        Checkpoint third = changed.get(2);
        changed.set(2, new Checkpoint(third.step(), third.hash() ^ 1));
        Verdict verdict = Proof.of(new Recording(played.level(), played.replay(), changed));
        assertThat(verdict).isEqualTo(new Verdict.Diverged(30, changed.get(2), third.hash()));
        assertThat(verdict.in(WORDS))
                .isEqualTo(
                        "went apart between step 30 and step 60: the state was "
                                + Hex.of(third.hash() ^ 1)
                                + ", and is "
                                + Hex.of(third.hash()));
    }

    @Test
    void anotherAccuracyIsNotTheSame() {
        Recording played = Recordings.sound();
        Replay draft =
                new Replay(played.replay().levelHash(), played.replay().acts(), Accuracy.DRAFT);
        Verdict verdict = Proof.of(new Recording(played.level(), draft, played.checkpoints()));
        assertThat(verdict.isSame()).isFalse();
    }

    @Test
    void anotherStartIsToldAsSuch() {
        Recording played = Recordings.sound();
        List<Checkpoint> changed = new ArrayList<>(played.checkpoints());
        changed.set(0, new Checkpoint(0, 0));
        Verdict verdict = Proof.of(new Recording(played.level(), played.replay(), changed));
        assertThat(verdict.in(WORDS))
                .startsWith(
                        "went apart from the start: the state at step 0 was 0000000000000000,"
                                + " and is ");
    }

    @Test
    void aClickThatIsRefusedIsTold() {
        Recording played = Recordings.sound();
        Act wall = new Act(10, "wall");
        Replay other =
                new Replay(played.replay().levelHash(), List.of(wall), played.replay().accuracy());
        Verdict verdict = Proof.of(new Recording(played.level(), other, played.checkpoints()));
        assertThat(verdict).isEqualTo(new Verdict.Refused(wall, ClickResult.NOT_CLICKABLE));
        assertThat(verdict.in(WORDS))
                .isEqualTo(
                        "the click on \"wall\" at step 10 was refused: this one stays"
                                + " as it is");
    }

    @ParameterizedTest
    @MethodSource("refusals")
    void everyRefusalHasItsWords(ClickResult result) {
        Verdict refused = new Verdict.Refused(new Act(1, "a"), result);
        assertThat(refused.in(WORDS)).startsWith("the click on \"a\" at step 1 was refused: ");
    }

    static Stream<ClickResult> refusals() {
        return Stream.of(ClickResult.values()).filter(result -> result != ClickResult.DONE);
    }
}

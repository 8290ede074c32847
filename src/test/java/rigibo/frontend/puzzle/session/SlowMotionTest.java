package rigibo.frontend.puzzle.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.PlayedLevel;
import rigibo.frontend.puzzle.PuzzleScene;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;

import java.util.List;

/** Slow motion shows more pictures of the same steps. */
class SlowMotionTest {

    private final Level level = PlayedLevel.twoBoxes();

    private static RigidBody ball(Session session) {
        return session.game().balls().get(0);
    }

    private Session falling(Pace pace) {
        Session session = new Session(level, Accuracy.GAME);
        session.game().act("box");
        session.pace(pace);
        return session;
    }

    @ParameterizedTest
    @EnumSource(Pace.class)
    void theSameStepsGiveTheSameBits(Pace pace) {
        Session full = falling(Pace.FULL);
        Session slow = falling(pace);
        for (int step = 0; step < 60; step++) {
            full.frame();
            for (int frame = 0; frame < pace.framesPerStep(); frame++) {
                slow.frame();
            }
        }
        assertThat(slow.game().pool().stateHash()).isEqualTo(full.game().pool().stateHash());
    }

    @Test
    void atFullSpeedThePictureIsThatOfTheLastStep() {
        Session session = falling(Pace.FULL);
        for (int frame = 0; frame < 20; frame++) {
            session.frame();
            assertThat(session.pose(ball(session))).isEqualTo(Pose.of(ball(session)));
        }
    }

    @Test
    void betweenStepsBodiesAreOnTheirWay() {
        Session session = falling(Pace.QUARTER);
        for (int frame = 0; frame < 40; frame++) {
            session.frame();
        }
        double before = session.pose(ball(session)).y();
        session.frame();
        double way = ball(session).y() - before;
        assertThat(way).as("falls").isNegative();
        for (int quarter = 1; quarter <= 4; quarter++) {
            double seen = session.pose(ball(session)).y();
            assertThat(seen).isCloseTo(before + quarter * way / 4, within(1e-12));
            session.frame();
        }
    }

    @Test
    void changingTheSpeedMovesNothing() {
        Session session = falling(Pace.FULL);
        for (int frame = 0; frame < 20; frame++) {
            session.frame();
        }
        Pose seen = session.pose(ball(session));
        session.pace(Pace.HALF);
        assertThat(session.pose(ball(session))).isEqualTo(seen);
    }

    @Test
    void isSlowedAndQuickenedByKeysAndSaysSo() {
        PlayedLevel played = new PlayedLevel(level);
        played.keys(Key.S);
        assertThat(played.texts()).contains("half speed");
        assertThat(played.turns(60).counts()).endsWith(" 0.5 s");
        played.keys(Key.S);
        assertThat(played.texts()).contains("quarter speed");
        assertThat(played.turns(48).counts()).endsWith(" 0.7 s");
        played.keys(Key.N, Key.N);
        assertThat(played.turns(18).counts()).endsWith(" 1.0 s");
    }

    @Test
    void theButtonGoesRoundAllSpeeds() {
        PlayedLevel played = new PlayedLevel(level);
        played.press("Slow motion").press("Slow motion");
        assertThat(played.texts()).contains("quarter speed");
        played.press("Slow motion");
        assertThat(played.texts()).noneMatch(words -> words.endsWith(" speed"));
    }

    @Test
    void boxesAreDeletedMeanwhile() {
        PlayedLevel played = new PlayedLevel(level);
        played.keys(Key.S, Key.S).turns(8).clickBox();
        assertThat(played.counts()).startsWith("1 click ");
    }

    /** In any level but the first, which explains itself. */
    @Test
    void aWorldThatCannotKeepRealTimeSaysSo() {
        Scene second = new PuzzleScene(new RecordingDirector(), List.of(level, level), 1);
        PlayedLevel.clickBox(second);
        second.step();
        second.paced(0.97);
        assertThat(RecordingCanvas.of(second).texts()).noneMatch(it -> it.endsWith("real time"));
        second.paced(0.4);
        assertThat(RecordingCanvas.of(second).texts()).contains("0.40× real time");
    }

    /** Before the first click nothing moves that could be late, and the task is to be read. */
    @Test
    void theTaskIsReadOnASlowMachineToo() {
        PlayedLevel played = new PlayedLevel(level);
        played.scene.paced(0.4);
        assertThat(played.texts()).contains("click a box to delete it");
        assertThat(played.texts()).noneMatch(words -> words.endsWith("real time"));
    }
}

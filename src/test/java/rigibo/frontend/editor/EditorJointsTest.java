package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.frontend.editor.TwoBoxes.box;
import static rigibo.frontend.editor.TwoBoxes.erase;
import static rigibo.frontend.editor.TwoBoxes.joined;
import static rigibo.frontend.editor.TwoBoxes.problems;
import static rigibo.frontend.editor.TwoBoxes.withTwoBoxes;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Joint;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.EffectUse;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Key;

import java.util.List;

/** Joints are made, moved and changed by the pointer alone, and every edit can be taken back. */
class EditorJointsTest {

    private static Point point(Author author, String pointer) {
        return new Point(author.number(pointer + "/0"), author.number(pointer + "/1"));
    }

    @ParameterizedTest
    @EnumSource(LevelJoint.Type.class)
    void twoClicksJoinTwoBodiesInALevelWithoutErrors(LevelJoint.Type type) {
        Author author = joined(type);
        LoadedLevel level = new LevelLoader().parse("draft", author.draft().toString());
        assertThat(level.problems()).isEmpty();
        LevelJoint joint = level.level().orElseThrow().joints().get(0);
        assertThat(joint.type()).isEqualTo(type);
        assertThat(List.of(joint.a(), joint.b())).containsExactly("rigibo1", "rigibo2");
        assertThat(new Point(joint.toX(), joint.toY())).isEqualTo(new Point(4.3, 4.2));
        Point from = type.hasTwoPoints() ? new Point(4.2, 5.8) : new Point(4.3, 4.2);
        assertThat(new Point(joint.x(), joint.y())).isEqualTo(from);
        assertThat(EffectUse.declared(author.draft())).contains("joints");
    }

    @ParameterizedTest
    @EnumSource(LevelJoint.Type.class)
    void aJointIsOneEditAndUndoneByOne(LevelJoint.Type type) {
        Author author = withTwoBoxes();
        Draft before = author.draft();
        author.take(type);
        author.drag(4.2, 5.8, 6, 8);
        assertThat(author.draft().at("/joints")).hasSize(1);
        author.control(Key.Z);
        assertThat(author.draft()).isEqualTo(before);
        author.control(Key.Y);
        assertThat(author.draft().at("/joints")).hasSize(1);
    }

    /** A body on the backdrop hangs on a hook; a motor drives the body, not the hook. */
    @ParameterizedTest
    @EnumSource(LevelJoint.Type.class)
    void theBackdropGetsAHook(LevelJoint.Type type) {
        for (boolean isHookFirst : new boolean[] {true, false}) {
            Author author = withTwoBoxes();
            author.take(type);
            author.clickWorld(isHookFirst ? 6 : 4, isHookFirst ? 8 : 6);
            author.clickWorld(isHookFirst ? 4 : 6, isHookFirst ? 6 : 8);
            assertThat(author.draft().at("/joints/0/a").asString()).isEqualTo("hook1");
            assertThat(author.draft().at("/joints/0/b").asString()).isEqualTo("rigibo1");
            assertThat(problems(author)).isEmpty();
            String anchor = type.hasTwoPoints() ? "from" : "at";
            Item hook = author.draft().lastBody();
            assertThat(hook.isFixed()).isTrue();
            assertThat(hook.place()).isEqualTo(point(author, "/joints/0/" + anchor));
        }
    }

    @Test
    void aThingClickedTwiceIsPinnedToAHookOnIt() {
        Author author = withTwoBoxes();
        author.take(LevelJoint.Type.HINGE);
        author.clickWorld(4.2, 6.2);
        author.clickWorld(4.2, 6.2);
        assertThat(author.draft().lastBody().place()).isEqualTo(new Point(4.2, 6.2));
        assertThat(problems(author)).isEmpty();
    }

    @Test
    void aMiddleThatIsNearIsWhatIsMeant() {
        Author author = withTwoBoxes();
        author.take(LevelJoint.Type.ROPE);
        author.clickWorld(4.11, 6.08);
        author.clickWorld(3.92, 3.93);
        assertThat(point(author, "/joints/0/from")).isEqualTo(new Point(4, 6));
        assertThat(point(author, "/joints/0/to")).isEqualTo(new Point(4, 4));
    }

    @Test
    void twoClicksOnTheBackdropJoinNothing() {
        Author author = withTwoBoxes();
        Draft before = author.draft();
        author.take(LevelJoint.Type.ROD);
        author.clickWorld(6, 8);
        author.clickWorld(7, 8);
        assertThat(author.draft()).isEqualTo(before);
        assertThat(author.scene.escaped()).isTrue();
        assertThat(author.draft()).isEqualTo(before);
    }

    @Test
    void anAnchorIsDraggedAndAMereClickLeavesItWhereItIs() {
        Author author = joined(LevelJoint.Type.ROPE);
        author.drag(4.3, 4.2, 3.8, 4.4);
        assertThat(point(author, "/joints/0/to")).isEqualTo(new Point(3.8, 4.4));
        assertThat(point(author, "/joints/0/from")).isEqualTo(new Point(4.2, 5.8));
        Draft before = author.draft();
        author.clickWorld(3.82, 4.43);
        assertThat(author.draft()).isEqualTo(before);
        author.control(Key.Z);
        assertThat(point(author, "/joints/0/to")).isEqualTo(new Point(4.3, 4.2));
    }

    @Test
    void aSecondClickOnAPinChoosesWhatLiesUnderIt() {
        Author author = joined(LevelJoint.Type.HINGE);
        author.clickWorld(6, 8);
        author.clickWorld(4.3, 4.2);
        assertThat(author.look().texts()).contains("Hinge");
        author.clickWorld(4.3, 4.2);
        assertThat(author.look().texts()).doesNotContain("Hinge").contains("rigibo2");
    }

    @Test
    void aHookIsDraggedByThePinInIt() {
        Author author = withTwoBoxes();
        author.take(LevelJoint.Type.HINGE);
        author.clickWorld(4, 6);
        author.clickWorld(6, 8);
        author.take(Author.SELECT);
        author.drag(6, 8, 3, 7);
        Item hook = author.draft().lastBody();
        assertThat(hook.place().minus(new Point(3, 7)).length()).isLessThan(1e-9);
        assertThat(point(author, "/joints/0/at")).isEqualTo(hook.place());
    }

    @Test
    void pointsGoAlongWithWhatTheyHold() {
        Author author = joined(LevelJoint.Type.SPRING);
        author.drag(3.8, 3.8, 5.8, 2.8);
        assertThat(point(author, "/joints/0/to")).isEqualTo(new Point(6.3, 3.2));
        assertThat(point(author, "/joints/0/from")).isEqualTo(new Point(4.2, 5.8));
        author.scene.keyPressed(Key.Q);
        Item box = author.draft().item("/bodies/2").orElseThrow();
        Point held = box.toOwn(point(author, "/joints/0/to"));
        // Level files state a tenth of a millimetre.
        assertThat(held.minus(new Point(0.3, 0.2)).length()).isLessThan(1e-4);
    }

    /** A round of turns by single degrees, as one drag of the handle is. */
    @Test
    void aDragRoundsOnceAndNotAtEveryMove() {
        Author author = joined(LevelJoint.Type.ROD);
        author.clickWorld(3.8, 3.8);
        double stalk = Math.hypot(0.5, 0.5) + 26 / View.camera(author.draft()).scale();
        author.turnHandle(4, 4, stalk, 360);
        Point held = point(author, "/joints/0/to");
        assertThat(author.number("/bodies/2/angle")).isCloseTo(0, within(1e-9));
        assertThat(held.minus(new Point(4.3, 4.2)).length()).isLessThan(1e-9);
    }

    /** A wheel takes its axle along; a car leaves it where it is. */
    @Test
    void aPointOfTwoGoesWithTheSmaller() {
        Author author = Author.with(NewLevel.draft().plus(box(6, 5)));
        author.take(LevelJoint.Type.HINGE);
        author.clickWorld(2.9, 2);
        author.clickWorld(6, 5);
        author.take(Author.SELECT);
        author.drag(1.2, 2, 1.2, 1);
        assertThat(point(author, "/joints/0/at")).isEqualTo(new Point(6, 5));
        author.drag(6.3, 5.3, 6.3, 6.3);
        assertThat(point(author, "/joints/0/at")).isEqualTo(new Point(6, 6));
    }

    @Test
    void whatIsRemovedTakesItsJointsAlongAndWhatIsRenamedKeepsThem() {
        Author author = joined(LevelJoint.Type.ROPE);
        author.clickWorld(3.8, 6.2);
        author.press("rigibo1");
        for (int i = 0; i < "rigibo1".length(); i++) {
            author.scene.keyPressed(Key.BACKSPACE);
        }
        author.type("top");
        assertThat(author.draft().at("/joints/0/a").asString()).isEqualTo("top");
        assertThat(problems(author)).isEmpty();
        author.press("Remove");
        assertThat(author.draft().at("/joints").isMissingNode()).isTrue();
        assertThat(EffectUse.declared(author.draft())).doesNotContain("joints");
    }

    @Test
    void ballsThatCloseUpKeepTheirJoints() {
        Author author = withTwoBoxes();
        author.take(Author.BALL);
        author.clickWorld(6, 8);
        author.clickWorld(7.5, 8);
        author.take(LevelJoint.Type.ROPE);
        author.clickWorld(7.5, 8);
        author.clickWorld(4, 6);
        assertThat(author.draft().at("/joints/0/a").asString()).isEqualTo("ball3");
        author.take(Author.SELECT);
        author.clickWorld(6, 8);
        author.press("Remove");
        assertThat(author.draft().at("/joints/0/a").asString()).isEqualTo("ball2");
        assertThat(problems(author)).isEmpty();
    }

    @Test
    void aJointIsRemovedAlone() {
        Author author = joined(LevelJoint.Type.WELD);
        author.clickWorld(4.3, 4.2);
        author.scene.keyPressed(Key.DELETE);
        assertThat(author.draft().at("/joints").isMissingNode()).isTrue();
        assertThat(author.draft().at("/bodies")).hasSize(3);
    }

    @Test
    void numbersAreSwitchedOnTypedAndTakenBack() {
        Author author = joined(LevelJoint.Type.HINGE);
        author.press("Limits");
        author.press("45");
        erase(author, 2);
        author.type("30");
        assertThat(point(author, "/joints/0/limits")).isEqualTo(new Point(-45, 30));
        author.press("Motor");
        author.press("100");
        erase(author, 3);
        author.type("250");
        assertThat(author.number("/joints/0/motor/most")).isEqualTo(250);
        author.press("Springy");
        assertThat(author.number("/joints/0/spring/hertz")).isEqualTo(1);
        assertThat(problems(author)).isEmpty();
        author.press("Springy");
        author.press("Motor");
        author.press("Limits");
        assertThat(author.draft().at("/joints/0").size()).isEqualTo(4);
        author.press("rigibo1 – rigibo2");
        assertThat(author.draft().at("/joints/0/a").asString()).isEqualTo("rigibo2");
    }

    /** A box on a rope of 2 m falls until it is taut, and is never farther from its hook. */
    @Test
    void whatHangsOnARopeSwingsWithinItsLength() {
        Author author = withTwoBoxes();
        author.take(LevelJoint.Type.ROPE);
        author.clickWorld(6, 6);
        author.clickWorld(4, 6);
        LoadedLevel loaded = new LevelLoader().parse("draft", author.draft().toString());
        Level level = loaded.level().orElseThrow();
        assertThat(level.joints()).hasSize(1);
        PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);
        double lowest = Double.POSITIVE_INFINITY;
        double farthest = 0;
        for (int i = 0; i < 60; i++) {
            game.step();
            Joint rope = game.pool().joints().get(0);
            farthest = Math.max(farthest, Math.hypot(rope.xB() - rope.xA(), rope.yB() - rope.yA()));
            lowest = Math.min(lowest, rope.yB());
        }
        assertThat(lowest).isLessThan(5);
        // J1: what holds gapes by less than a millimetre.
        assertThat(farthest).isLessThan(2 + 1e-3);
    }
}

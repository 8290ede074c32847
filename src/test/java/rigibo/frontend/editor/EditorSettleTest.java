package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.frontend.editor.TwoBoxes.joined;
import static rigibo.frontend.editor.TwoBoxes.withTwoBoxes;

import org.junit.jupiter.api.Test;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.scene.Key;

/** Settling begins the level where everything rests, as one change. */
class EditorSettleTest {

    /** Turns of the editor in which anything settles: 60 of them let 8 s pass. */
    private static final int LONG_ENOUGH = 300;

    private static void settle(Author author) {
        author.scene.keyPressed(Key.S);
        for (int i = 0; i < LONG_ENOUGH; i++) {
            author.scene.step();
        }
    }

    /** A slab under both boxes of {@link TwoBoxes}. */
    private static Author onASlab(Author author) {
        author.take(Author.BOX);
        author.drag(2.5, 2, 6.5, 2.5);
        author.press("Moves");
        return author;
    }

    @Test
    void boxesInTheAirFallOntoEachOther() {
        Author author = onASlab(withTwoBoxes());
        Draft before = author.draft();
        settle(author);
        assertThat(author.number("/bodies/2/y")).isCloseTo(3, within(5e-3));
        assertThat(author.number("/bodies/1/y")).isCloseTo(4, within(5e-3));
        assertThat(author.look().texts()).anyMatch(text -> text.startsWith("Everything rests"));
        Draft settled = author.draft();
        author.control(Key.Z);
        assertThat(author.draft()).isEqualTo(before);
        author.control(Key.Y);
        assertThat(author.draft()).isEqualTo(settled);
        settle(author);
        assertThat(author.number("/bodies/1/y"))
                .as("it rests already")
                .isCloseTo(settled.at("/bodies/1/y").asDouble(), within(1e-3));
    }

    @Test
    void aSlackRopeStaysAsLongAsItWas() {
        Author author = onASlab(joined(LevelJoint.Type.ROPE));
        double length = Math.hypot(0.1, 1.6);
        settle(author);
        assertThat(author.number("/joints/0/length")).isCloseTo(length, within(1e-3));
        assertThat(author.number("/joints/0/from/1"))
                .as("what a rope joins does not meet")
                .isCloseTo(2.8, within(0.1));
    }

    @Test
    void whatFallsOutOfTheWorldIsNamedAndNothingChanges() {
        Author author = withTwoBoxes();
        Draft before = author.draft();
        settle(author);
        assertThat(author.draft()).isEqualTo(before);
        assertThat(author.look().texts())
                .anyMatch(text -> text.contains("rigibo") && text.contains("out of the world"));
    }

    @Test
    void aKeyStopsItAndChangesNothing() {
        Author author = onASlab(withTwoBoxes());
        Draft before = author.draft();
        author.scene.keyPressed(Key.S);
        author.scene.step();
        assertThat(author.draft()).isNotEqualTo(before);
        author.scene.keyPressed(Key.S);
        assertThat(author.draft()).isEqualTo(before);
        author.scene.step();
        assertThat(author.draft()).isEqualTo(before);
    }

    @Test
    void aHingeKeepsItsLimitsWhereTheyWere() {
        Author author = withTwoBoxes();
        author.take(LevelJoint.Type.HINGE);
        author.clickWorld(3.6, 5.8);
        author.clickWorld(2.6, 5.8);
        author.take(Author.SELECT);
        author.press("Limits");
        double lower = author.number("/joints/0/limits/0");
        author.scene.keyPressed(Key.TAB);
        author.take(Author.SELECT);
        author.clickWorld(4, 4);
        author.press("Remove");
        settle(author);
        double turned = author.number("/bodies/1/angle");
        assertThat(Math.abs(turned)).as("it hangs from its corner").isGreaterThan(20);
        assertThat(author.number("/joints/0/limits/0")).isCloseTo(lower - turned, within(0.5));
    }
}

package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.frontend.editor.TwoBoxes.joined;
import static rigibo.frontend.editor.TwoBoxes.problems;
import static rigibo.frontend.editor.TwoBoxes.withTwoBoxes;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.editor.draft.Clicks;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.EffectUse;
import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;

import java.util.List;

/** An author chooses with the pointer what a click does in play; the level has no errors. */
class EditorVerbsTest {

    /** Distance from the middle of a stepper's value to its plus, px. */
    private static final double PLUS = 44;

    private static String text(Author author, String pointer) {
        return author.draft().at(pointer).asString("");
    }

    /** Steps the value that says something to the next one. */
    private static void next(Author author, String value) {
        double[] at = author.look().middleOf(value);
        author.click(at[0] + PLUS, at[1]);
    }

    @Test
    void aRopeIsMadeCuttableAndGetsAName() {
        Author author = joined(LevelJoint.Type.ROPE);
        next(author, "stays");
        assertThat(text(author, "/joints/0/click")).isEqualTo("cut");
        assertThat(text(author, "/joints/0/id")).isEqualTo("rope1");
        assertThat(problems(author)).isEmpty();
        next(author, "cut");
        assertThat(author.draft().at("/joints/0/click").isMissingNode()).isTrue();
        author.control(Key.Z);
        assertThat(text(author, "/joints/0/click")).as("undone").isEqualTo("cut");
    }

    @Test
    void aMotorIsMadeASwitchThatBeginsOff() {
        Author author = joined(LevelJoint.Type.HINGE);
        author.press("Motor");
        next(author, "stays");
        assertThat(text(author, "/joints/0/click")).isEqualTo("pull");
        assertThat(problems(author)).isEmpty();
        next(author, "pulled");
        next(author, "on");
        assertThat(text(author, "/joints/0/click")).isEqualTo("switch");
        assertThat(author.draft().at("/joints/0/on").asBoolean(true)).isFalse();
        assertThat(problems(author)).isEmpty();
    }

    @Test
    void aBodyFreezesOrBlowsUpInPlaceOfBeingDeleted() {
        Author author = withTwoBoxes();
        author.clickWorld(4, 6);
        author.press("Play");
        author.press("Deletable");
        next(author, "stays");
        assertThat(text(author, "/bodies/1/click")).isEqualTo("freeze");
        assertThat(problems(author)).isEmpty();
        next(author, "frozen");
        assertThat(text(author, "/bodies/1/click")).isEqualTo("light");
        assertThat(author.number("/bodies/1/blast/impulse")).isPositive();
        assertThat(problems(author)).isEmpty();
        next(author, "bomb");
        assertThat(author.draft().at("/bodies/1/click").isMissingNode()).isTrue();
        assertThat(author.draft().at("/bodies/1/blast").isMissingNode()).isTrue();
    }

    @Test
    void aFixedBodyBecomesAFanThatIsSwitched() {
        Author author = withTwoBoxes();
        author.clickWorld(4, 6);
        author.press("Moves");
        author.press("Play");
        author.press("Deletable");
        author.press("Fan");
        assertThat(EffectUse.declared(author.draft())).contains("fan");
        next(author, "stays");
        assertThat(text(author, "/bodies/1/click")).isEqualTo("switch");
        assertThat(problems(author)).isEmpty();
        author.press("Fan");
        assertThat(EffectUse.declared(author.draft())).doesNotContain("fan");
    }

    @Test
    void solutionsFollowTheNamesOfJointsAndGoWithThem() {
        Author author = joined(LevelJoint.Type.ROPE);
        next(author, "stays");
        Solution cut = new Solution(List.of(new Click(1, "rope1")));
        Draft solved = Clicks.keep(author.draft(), cut);
        assertThat(solved.at("/solutions/0/clicks/0/joint").asString("")).isEqualTo("rope1");
        Draft renamed = Clicks.jointRenamed(solved, "rope1", "line");
        assertThat(renamed.at("/solutions/0/clicks/0/joint").asString("")).isEqualTo("line");
        Draft without = solved.without(solved.item("/bodies/1").orElseThrow());
        assertThat(without.at("/joints").isEmpty()).isTrue();
        assertThat(without.at("/solutions").isEmpty()).isTrue();
    }

    /** The panes at their fullest: a hinge with all its parts, a bomb, a fan. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void whatAClickDoesIsLegible(String language) {
        boolean isEnglish = language.equals("en");
        Author author = withTwoBoxes(language);
        author.take(LevelJoint.Type.HINGE);
        author.clickWorld(4.2, 5.8);
        author.clickWorld(4.3, 4.2);
        for (String part :
                isEnglish
                        ? List.of("Motor", "Limits", "Springy")
                        : List.of("Motor", "Anschläge", "Federnd")) {
            author.press(part);
        }
        next(author, isEnglish ? "stays" : "bleibt");
        assertThat(Legibility.faults(author.scene)).isEmpty();
        author.take(Author.SELECT);
        author.clickWorld(3.7, 6.3);
        author.press(isEnglish ? "Play" : "Spiel");
        author.press(isEnglish ? "Deletable" : "Löschbar");
        next(author, isEnglish ? "stays" : "bleibt");
        next(author, isEnglish ? "frozen" : "Stein");
        assertThat(Legibility.faults(author.scene)).isEmpty();
        author.press(isEnglish ? "Shape" : "Form");
        author.press(isEnglish ? "Moves" : "Beweglich");
        author.press(isEnglish ? "Play" : "Spiel");
        author.press(isEnglish ? "Fan" : "Gebläse");
        assertThat(Legibility.faults(author.scene)).isEmpty();
    }

    @Test
    void aBodyIsDrivenAlongAPathWhoseStopsAreDragged() {
        Author author = withTwoBoxes();
        author.clickWorld(4, 6);
        author.press("Play");
        author.press("Deletable");
        author.press("Path");
        assertThat(author.draft().at("/bodies/1/path/points").size()).isEqualTo(1);
        author.take(Author.SELECT);
        author.drag(6, 6, 6, 8);
        assertThat(author.number("/bodies/1/path/points/0/1")).isCloseTo(8, within(1e-9));
        assertThat(problems(author)).isEmpty();
        author.press("Path");
        assertThat(author.draft().at("/bodies/1/dynamic").asBoolean(true)).isFalse();
        author.control(Key.Z);
        assertThat(author.draft().at("/bodies/1/path/points/0/1").asDouble(0)).isEqualTo(8);
    }
}

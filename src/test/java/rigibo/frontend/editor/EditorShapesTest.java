package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.frontend.editor.TwoBoxes.joined;
import static rigibo.frontend.editor.TwoBoxes.problems;
import static rigibo.frontend.editor.TwoBoxes.withTwoBoxes;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;

/** Shapes of every kind are drawn by the pointer, and make a level without errors. */
class EditorShapesTest {

    private static final String LAST = "/bodies/3";

    private static String type(Author author, String body) {
        return author.draft().at(body + "/shape/type").asString("");
    }

    @Test
    void aCapsuleIsDraggedFromEndToEndAndByItsEnds() {
        Author author = withTwoBoxes();
        author.take(Author.CAPSULE);
        author.drag(5, 8, 7, 8);
        assertThat(author.number(LAST + "/shape/length")).isCloseTo(2, within(1e-9));
        assertThat(author.number(LAST + "/x")).isCloseTo(6, within(1e-9));
        assertThat(problems(author)).isEmpty();
        author.take(Author.SELECT);
        author.drag(7, 8, 5, 9);
        assertThat(author.number(LAST + "/shape/length")).isCloseTo(1, within(1e-9));
        assertThat(author.number(LAST + "/angle")).isCloseTo(90, within(1e-9));
        assertThat(author.number(LAST + "/y")).isCloseTo(8.5, within(1e-9));
        assertThat(problems(author)).isEmpty();
    }

    @Test
    void aBoxIsRoundedNoMoreThanItsSizeAllows() {
        Author author = withTwoBoxes();
        author.clickWorld(4, 6);
        author.press("Round m");
        double[] at = author.look().middleOf("Round m");
        author.click(670, at[1]);
        TwoBoxes.erase(author, 9);
        author.type("0.4");
        assertThat(author.number("/bodies/1/shape/round")).isEqualTo(0.4);
        author.drag(4.5, 6.5, 4, 6);
        assertThat(author.number("/bodies/1/shape/round")).isLessThanOrEqualTo(0.45 * 0.5);
        assertThat(problems(author)).isEmpty();
    }

    @Test
    void aConcaveOutlineIsCutIntoPartsThatCanBeTakenApart() {
        Author author = withTwoBoxes();
        author.take(Author.CORNERS);
        author.clickWorld(5, 8);
        author.clickWorld(7, 8);
        author.clickWorld(7, 9);
        author.clickWorld(6, 8.4);
        author.clickWorld(5, 9);
        author.scene.keyPressed(Key.ENTER);
        assertThat(type(author, LAST)).isEqualTo("compound");
        int parts = author.draft().at(LAST + "/shape/parts").size();
        assertThat(parts).isGreaterThan(1);
        assertThat(problems(author)).isEmpty();
        Draft whole = author.draft();
        author.take(Author.SELECT);
        author.press("Take apart");
        assertThat(author.draft().at("/bodies").size()).isEqualTo(3 + parts);
        author.control(Key.Z);
        assertThat(author.draft()).isEqualTo(whole);
    }

    @Test
    void aPolygonThatWasDentedIsCutByAButton() {
        Author author = withTwoBoxes();
        author.take(Author.CORNERS);
        author.clickWorld(5, 8);
        author.clickWorld(7, 8);
        author.clickWorld(6, 9.5);
        author.scene.keyPressed(Key.ENTER);
        author.take(Author.CORNERS);
        author.clickWorld(1, 8);
        author.clickWorld(2, 8);
        author.clickWorld(2, 9);
        author.clickWorld(1, 9);
        author.scene.keyPressed(Key.ENTER);
        author.take(Author.SELECT);
        author.drag(2, 9, 1.25, 8.25);
        assertThat(problems(author)).singleElement().asString().contains("E110");
        author.press("Cut into parts");
        assertThat(problems(author)).isEmpty();
    }

    @Test
    void gluedBodiesAreOneAndKeepTheJointsOfBoth() {
        Author author = joined(LevelJoint.Type.ROPE);
        author.take(Author.BOX);
        author.drag(5, 3.5, 6, 4.5);
        author.take(Author.GLUE);
        author.clickWorld(5.5, 4);
        author.clickWorld(3.7, 4);
        assertThat(author.draft().at("/bodies").size()).isEqualTo(3);
        assertThat(author.draft().at("/joints/0/b").asString("")).isEqualTo("rigibo3");
        assertThat(author.number("/bodies/2/shape/parts/1/x")).isCloseTo(-1.5, within(1e-9));
        assertThat(problems(author)).isEmpty();
        author.control(Key.Z);
        assertThat(author.draft().at("/joints/0/b").asString("")).isEqualTo("rigibo2");
    }

    @Test
    void aLandscapeHasItsMatterBelowUntilItIsTurnedOver() {
        Author author = withTwoBoxes();
        author.take(Author.LANDSCAPE);
        author.clickWorld(0.5, 0.5);
        author.clickWorld(4, 0.4);
        author.clickWorld(8, 0.6);
        author.scene.keyPressed(Key.ENTER);
        assertThat(type(author, LAST)).isEqualTo("chain");
        assertThat(author.draft().at(LAST + "/material").asString("")).isEqualTo("stone");
        double first = author.number(LAST + "/shape/points/0/0");
        assertThat(first).as("from right to left").isGreaterThan(0);
        assertThat(problems(author)).isEmpty();
        author.take(Author.SELECT);
        author.press("Other side");
        assertThat(author.number(LAST + "/shape/points/2/0")).isEqualTo(first);
        author.drag(4, 0.4, 4, 1);
        assertThat(author.number(LAST + "/shape/points/1/1") + author.number(LAST + "/y"))
                .isCloseTo(1, within(1e-9));
    }

    @Test
    void aLoopDrawnAboutTheBallIsACave() {
        Author author = withTwoBoxes();
        author.take(Author.LANDSCAPE);
        author.clickWorld(0.2, 0.2);
        author.clickWorld(8.8, 0.2);
        author.clickWorld(8.8, 9.8);
        author.clickWorld(0.2, 9.8);
        author.clickWorld(0.2, 0.2);
        assertThat(author.draft().at(LAST + "/shape/loop").asBoolean(false)).isTrue();
        double firstY = author.number(LAST + "/shape/points/0/1");
        double secondY = author.number(LAST + "/shape/points/1/1");
        assertThat(firstY).as("clockwise, from the upper left").isGreaterThan(0);
        assertThat(secondY).isGreaterThan(0);
        assertThat(problems(author)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void whatIsDrawnAndToldOfItIsLegible(String language) {
        Author author = withTwoBoxes(language);
        author.take(Author.LANDSCAPE);
        author.clickWorld(0.5, 0.5);
        author.clickWorld(4, 0.4);
        assertThat(Legibility.faults(author.scene)).isEmpty();
        author.scene.keyPressed(Key.ENTER);
        assertThat(Legibility.faults(author.scene)).isEmpty();
        author.take(Author.GLUE);
        author.clickWorld(4, 6);
        author.clickWorld(4, 4);
        assertThat(Legibility.faults(author.scene)).isEmpty();
    }
}

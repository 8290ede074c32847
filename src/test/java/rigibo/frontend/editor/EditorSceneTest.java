package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.EffectUse;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.replay.Recordings;
import rigibo.frontend.puzzle.replay.ReplayCode;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Modifier;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scenery;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;

class EditorSceneTest {

    /** Longer than a fall of a metre and the hold of three seconds take, in steps. */
    private static final int LONG_ENOUGH = 60 * 8;

    @TempDir private Path folder;

    private Path levels() {
        return folder.resolve("levels");
    }

    /** A RigiBo between ball and platform: the ledge of the new level is taken away. */
    private Author drop() {
        Author author = Author.withNewLevel(folder);
        author.take(Author.BOX);
        author.clickWorld(7, 1.75);
        author.take(Author.SELECT);
        author.drag(2, 2.55, 7, 2.5);
        author.clickWorld(2, 2);
        author.press("Remove");
        return author;
    }

    @Test
    void aLevelIsBuiltTriedSolvedAndSavedByThePointerAlone() {
        Author author = drop();
        win(author);
        author.press("Keep");
        author.press("New level");
        author.type(" to drop");
        author.press("Save");
        LoadedLevel saved = new LevelLoader().load(levels().resolve("new-level-to-drop.json"));
        assertThat(saved.problems()).isEmpty();
        assertThat(saved.level().orElseThrow().solutions()).hasSize(1);
        assertThat(saved.level().orElseThrow().bodies())
                .singleElement()
                .satisfies(
                        body -> {
                            assertThat(body.y()).isCloseTo(1.75, within(1e-9));
                            assertThat(body.deletable()).isTrue();
                        });
    }

    @Test
    void aStarIsChosenAfterASolutionAndProvedByAnotherTest() {
        Author author = drop();
        author.press("Star");
        assertThat(author.look().texts()).contains("Win a test first,");
        win(author);
        author.press("Keep");
        double[] feat = author.look().middleOf("no star");
        author.click(author.look().middleOf("no star")[0] + 95, feat[1]);
        assertThat(author.draft().at("/star/count").asInt()).isEqualTo(1);
        author.click(feat[0] + 95, feat[1]);
        assertThat(author.draft().at("/star/type").asString("")).isEqualTo("quick");
        assertThat(author.draft().at("/star/solution"))
                .isEqualTo(author.draft().at("/solutions/0"));
        author.press("Solved quickly");
        win(author);
        author.press("For the star");
        assertThat(author.draft().at("/star/solution/clicks").size()).isEqualTo(1);
        assertThat(TwoBoxes.problems(author)).isEmpty();
    }

    private static void win(Author author) {
        author.press("Test");
        author.click(560, 660);
        for (int i = 0; i < LONG_ENOUGH; i++) {
            author.scene.step();
        }
        author.scene.escaped();
    }

    @Test
    void escapeEndsTheTestAndLeavesTheDraftAsItWas() {
        Author author = drop();
        Draft before = author.draft();
        author.scene.keyPressed(Key.T);
        author.scene.step();
        assertThat(author.look().texts()).doesNotContain("Check");
        assertThat(author.scene.escaped()).isTrue();
        assertThat(author.look().texts()).contains("Check");
        assertThat(author.draft()).isEqualTo(before);
        author.scene.keyPressed(Key.T);
        author.scene.keyPressed(Key.T);
        assertThat(author.look().texts()).contains("Check");
    }

    @Test
    void aButtonOfTheTestLeadsBack() {
        Author author = drop();
        author.press("Test");
        author.press("Editor");
        assertThat(author.look().texts()).contains("Check");
    }

    @Test
    void aLevelWithErrorsIsNotPlayedButSaved() {
        Author author = Author.withNewLevel(folder);
        author.press("Test");
        assertThat(author.look().texts()).anyMatch(text -> text.startsWith("It cannot be played"));
        author.press("Save");
        assertThat(levels().resolve("new-level.json")).exists();
        assertThat(author.look().texts())
                .anyMatch(text -> text.startsWith("Saved, but it cannot be played yet"));
    }

    @Test
    void aLevelBecomesACodeAndIsOpenedFromOne() {
        Author author = drop();
        Draft made = author.draft();
        author.control(Key.C);
        author.press("Code");
        assertThat(author.director.copied).hasSize(2);
        author.control(Key.N);
        assertThat(author.scene.pasted(author.director.copied.get(1))).isTrue();
        assertThat(author.draft().document()).isEqualTo(made.document());
        assertThat(author.look().texts()).anyMatch(text -> text.startsWith("Opened from a code"));
        author.press("Save");
        assertThat(levels().resolve("new-level.json")).exists();
    }

    @Test
    void whatIsNoCodeOfALevelLeavesTheDraftAndSaysWhy() {
        Author author = drop();
        Draft before = author.draft();
        for (String text : List.of("", "hello", "RIGIBO-LEVEL-AAAA", replay())) {
            author.scene.pasted(text);
            assertThat(author.draft()).isSameAs(before);
            assertThat(author.look().texts())
                    .anyMatch(said -> said.startsWith("This cannot be opened. It is "));
        }
    }

    private static String replay() {
        return ReplayCode.of(Recordings.sound()).orElseThrow();
    }

    @Test
    void whatIsPastedWhileTypingIsWritten() {
        Author author = Author.withNewLevel(folder);
        author.press("New level");
        author.scene.pasted(" of\n ours");
        author.type("");
        assertThat(author.draft().at("/title/en").asString()).isEqualTo("New level of ours");
    }

    @Test
    void aPlayedDraftLeavesCodesToTheWindow() {
        Author author = drop();
        author.scene.keyPressed(Key.T);
        assertThat(author.scene.pasted(replay())).isFalse();
    }

    @Test
    void everyEditCanBeTakenBackAndMadeAgain() {
        Author author = drop();
        Draft made = author.draft();
        for (int i = 0; i < 4; i++) {
            author.control(Key.Z);
        }
        assertThat(author.draft()).isEqualTo(NewLevel.draft());
        for (int i = 0; i < 4; i++) {
            author.control(Key.Y);
        }
        assertThat(author.draft()).isEqualTo(made);
    }

    @Test
    void aCornersHandleSizesAndLeavesTheOtherCornerWhereItIs() {
        Author author = Author.with(NewLevel.draft());
        author.clickWorld(2, 2);
        author.drag(3.5, 2.2, 4, 2.5);
        assertThat(author.number("/bodies/0/shape/w")).isCloseTo(3.5, within(1e-9));
        assertThat(author.number("/bodies/0/shape/h")).isCloseTo(0.7, within(1e-9));
        assertThat(author.number("/bodies/0/x")).isCloseTo(2.25, within(1e-9));
        assertThat(author.number("/bodies/0/y")).isCloseTo(2.15, within(1e-9));
    }

    @Test
    void keysTurnByOneDegreeAndWithShiftByFifteen() {
        Author author = Author.with(NewLevel.draft());
        author.clickWorld(2, 2);
        author.scene.keyPressed(Key.Q);
        author.with(Key.Q, Modifier.SHIFT);
        assertThat(author.number("/bodies/0/angle")).isEqualTo(16);
    }

    @Test
    void theTurningHandleSnapsToFifteenDegreesWithShift() {
        Author author = Author.with(NewLevel.draft());
        author.clickWorld(2, 2);
        double stalk = Math.hypot(1.5, 0.2) + 26 / View.camera(author.draft()).scale();
        author.scene.held(EnumSet.of(Modifier.SHIFT));
        author.drag(2, 2 + stalk, 2 - stalk * Math.sin(0.5), 2 + stalk * Math.cos(0.5));
        assertThat(author.number("/bodies/0/angle")).isEqualTo(30);
    }

    @Test
    void aPolygonIsClosedByItsFirstCorner() {
        Author author = Author.with(NewLevel.draft());
        author.take(Author.CORNERS);
        author.clickWorld(4, 4);
        author.clickWorld(6, 4);
        author.clickWorld(5, 6);
        author.clickWorld(4, 4);
        assertThat(author.draft().at("/bodies/1/shape/points")).hasSize(3);
        assertThat(author.number("/bodies/1/x")).isCloseTo(5, within(1e-9));
    }

    @Test
    void aDentedPolygonIsToldAtTheBodyAndInTheList() {
        Author author = Author.with(NewLevel.draft());
        author.take(Author.CORNERS);
        author.clickWorld(4, 4);
        author.clickWorld(6, 4);
        author.clickWorld(6, 6);
        author.clickWorld(4, 6);
        author.scene.keyPressed(Key.ENTER);
        author.take(Author.SELECT);
        author.drag(6, 6, 4.5, 4.5);
        assertThat(author.look().texts()).contains("Not convex");
        author.scene.pointerMoved(
                View.camera(author.draft()).screenX(4.2), View.camera(author.draft()).screenY(4.2));
        assertThat(author.look().texts())
                .anyMatch(text -> text.startsWith("The outline is dented"))
                .noneMatch(text -> text.contains("E110"));
    }

    @Test
    void aPressOnAProblemChoosesWhatItConcerns() {
        Author author = Author.with(NewLevel.draft());
        author.drag(2, 2.55, 2, 2.3);
        author.clickWorld(5, 8);
        author.press("Overlaps something");
        assertThat(author.look().texts()).contains("ledge");
    }

    @Test
    void discsAndRegularPolygonsAreDrawnOutFromTheirMiddle() {
        Author author = Author.with(NewLevel.draft());
        author.take(Author.DISC);
        author.drag(4, 5, 4.5, 5);
        assertThat(author.number("/bodies/1/shape/r")).isCloseTo(0.5, within(1e-9));
        author.take(Author.REGULAR);
        author.scene.keyPressed(Key.DOWN);
        author.drag(6, 5, 6.5, 5);
        assertThat(author.draft().at("/bodies/2/shape/points")).hasSize(5);
        author.take(Author.BALL);
        author.clickWorld(6, 8);
        assertThat(author.number("/moreBalls/0/x")).isCloseTo(6, within(1e-9));
    }

    @Test
    void aNumberIsTypedIntoItsFieldAndHalfANumberIsNone() {
        Author author = Author.with(NewLevel.draft());
        author.press("-9.81");
        assertThat(author.scene.isTyping()).isTrue();
        for (int i = 0; i < 5; i++) {
            author.scene.keyPressed(Key.BACKSPACE);
        }
        author.type("-1,62");
        assertThat(author.number("/world/gravity/1")).isEqualTo(-1.62);
        assertThat(author.scene.scenery()).isEqualTo(Scenery.MOON);
        author.press("-1.62");
        author.type("x");
        assertThat(author.number("/world/gravity/1")).isEqualTo(-1.62);
        author.press("-1.62");
        author.scene.typed('5');
        assertThat(author.scene.escaped()).isTrue();
        assertThat(author.number("/world/gravity/1")).isEqualTo(-1.62);
    }

    @Test
    void duplicatesAreOfTheSameMaterialUnderAnotherName() {
        Author author = Author.with(NewLevel.draft());
        author.clickWorld(2, 2);
        author.control(Key.D);
        assertThat(author.draft().at("/bodies/1/material").asString()).isEqualTo("stone");
        assertThat(author.draft().at("/bodies/1/id").asString()).isEqualTo("stone1");
        author.scene.keyPressed(Key.DIGIT_4);
        assertThat(author.draft().at("/bodies/1/material").asString()).isEqualTo("ice");
        author.scene.keyPressed(Key.DELETE);
        assertThat(author.draft().at("/bodies")).hasSize(1);
    }

    @Test
    void theBallAndThePlatformCannotBeRemoved() {
        Author author = Author.with(NewLevel.draft());
        author.clickWorld(2, 2.55);
        author.scene.keyPressed(Key.DELETE);
        author.clickWorld(7, 1.2);
        author.scene.keyPressed(Key.DELETE);
        assertThat(author.draft()).isEqualTo(NewLevel.draft());
    }

    @Test
    void aChipDeclaresAnEffectOrTakesItBack() {
        Author author = Author.with(NewLevel.draft());
        author.press("rolling resistance");
        assertThat(EffectUse.declared(author.draft())).doesNotContain("rolling-resistance");
        author.press("rolling resistance");
        assertThat(EffectUse.declared(author.draft())).contains("rolling-resistance");
    }

    @Test
    void aLevelOfTheGameIsSavedAsOneOfThePlayers() throws IOException {
        Path own = LevelShelf.files().get(0);
        byte[] before = Files.readAllBytes(own);
        Author author = new Author(DraftFiles.open(own), Optional.of(folder), "en");
        author.clickWorld(author.number("/ball/x"), author.number("/ball/y"));
        author.scene.keyPressed(Key.UP);
        author.control(Key.S);
        assertThat(Files.readAllBytes(own)).isEqualTo(before);
        try (var saved = Files.list(levels())) {
            assertThat(saved)
                    .singleElement()
                    .satisfies(
                            file ->
                                    assertThat(Draft.of(json(file)).at("/ball/y").asDouble())
                                            .isCloseTo(author.number("/ball/y"), within(1e-9)));
        }
    }

    private static tools.jackson.databind.JsonNode json(Path file) {
        return new LevelLoader().load(file).document().orElseThrow();
    }

    @Test
    void whatIsLeftUnsavedIsOfferedAgain() {
        Author author = drop();
        Draft left = author.draft();
        author.scene.closed();
        Author later = Author.withNewLevel(folder);
        later.press("Take it up");
        assertThat(later.draft()).isEqualTo(left);
        later.press("Save");
        later.scene.closed();
        assertThat(Author.withNewLevel(folder).look().texts()).doesNotContain("Take it up");
    }

    @Test
    void whatIsThrownAwayIsNotOfferedAgain() {
        drop().scene.closed();
        Author later = Author.withNewLevel(folder);
        later.press("Throw it away");
        later.scene.closed();
        assertThat(Author.withNewLevel(folder).look().texts()).doesNotContain("Take it up");
    }

    @Test
    void whatIsOnTheDeskIsKeptWhenAnotherLevelIsOpened() {
        Author author = drop();
        Draft left = author.draft();
        author.press("Open");
        author.press("1-04-tilt.json");
        assertThat(author.draft().at("/id").asString()).isEqualTo("tilt");
        author.scene.closed();
        Author later = Author.withNewLevel(folder);
        later.press("Take it up");
        assertThat(later.draft()).isEqualTo(left);
    }

    @Test
    void aMissingFileIsANewLevelThatIsSavedThere() throws IOException {
        Path file = folder.resolve("mine.json");
        Author author = new Author(DraftFiles.open(file), Optional.empty(), "en");
        author.press("Save");
        assertThat(Draft.of(json(file)).without("/id")).isEqualTo(NewLevel.draft().without("/id"));
        assertThat(json(file).at("/id").asString()).isEqualTo("mine");
    }

    @Test
    void theCheckPlaysOnAThreadOfItsOwnAndTellsWhatItFound() throws InterruptedException {
        Author author = drop();
        author.drag(7, 2.5, 7, 4.5);
        author.press("Check");
        assertThat(author.look().texts()).anyMatch(EditorSceneTest::tellsProof);
        while (author.look().texts().stream().anyMatch(EditorSceneTest::tellsProof)) {
            Thread.sleep(20);
        }
        assertThat(author.look().texts()).contains("Not at rest");
        author.scene.closed();
    }

    @Test
    void aLevelIsHandedOverWhereNobodyFindsItsFile() {
        Author author = drop();
        assertThat(author.look().texts()).doesNotContain("File");
        author.director.handsOver = true;
        author.press("File");
        assertThat(author.director.handed)
                .containsExactly(Map.entry("new-level.json", author.draft().toString()));
    }

    private static boolean tellsProof(String text) {
        return text.startsWith("Playing it through; go on meanwhile. Games so far: ");
    }

    @Test
    void theWheelZoomsAndARightDragMovesTheView() {
        Author author = Author.with(NewLevel.draft());
        author.look();
        author.scene.scrolled(2, 270, 366);
        author.scene.pointerMoved(270, 366);
        author.scene.pointerPressed(PointerButton.RIGHT, 270, 366);
        author.scene.pointerMoved(300, 366);
        author.scene.pointerReleased(PointerButton.RIGHT, 300, 366);
        author.scene.keyPressed(Key.HOME);
        author.clickWorld(2, 2);
        assertThat(author.look().texts()).contains("ledge");
    }
}

package rigibo.frontend.editor.draft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.Solution;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

class DraftTest {

    private static final LevelLoader LOADER = new LevelLoader();

    static Stream<Path> levels() {
        return LevelShelf.files().stream();
    }

    @ParameterizedTest
    @MethodSource("levels")
    void everyFieldOfEveryLevelSurvivesBeingWrittenAndReadAgain(Path file) {
        JsonNode read = LOADER.load(file).document().orElseThrow();
        Draft draft = Draft.of(read);
        JsonNode again = parsed(draft.toString());
        assertThat(again).isEqualTo(read);
        assertThat(LOADER.parse("again", draft.toString()).level())
                .isEqualTo(LOADER.load(file).level());
    }

    @ParameterizedTest
    @MethodSource("levels")
    void takingEveryPartUpAndPuttingItDownChangesNothing(Path file) {
        Draft draft = Draft.of(LOADER.load(file).document().orElseThrow());
        Draft touched = draft;
        for (Item item : draft.items()) {
            touched = touched.with(item.at(item.place()).formed(item.form()));
        }
        assertThat(LOADER.parse("touched", touched.toString()).level())
                .isEqualTo(LOADER.load(file).level());
    }

    /** Each line was written anew for every list around it. */
    @Test
    void aLongListIsWrittenOnceAndNotForEachListAroundIt() {
        int numbers = 30_000;
        ArrayNode zeros = JsonNodeFactory.instance.arrayNode();
        IntStream.range(0, numbers).forEach(i -> zeros.add(0));
        Draft draft = NewLevel.draft().with("/bodies/0/y", zeros);
        assertThat(NewLevel.draft().toString()).as("loads the library's classes").isNotEmpty();
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
        assertThat(draft.toString()).isNotEmpty();
        long taken = threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
        // Ten letters a line, copied as the text grows; it took 2300 with the lines anew.
        assertThat(taken).isLessThan(100L * numbers);
    }

    /** A printer of the library's was begun for every name, word and number, of a kilobyte each. */
    @Test
    void manyBodiesAreWrittenWithoutAPrinterForEachWord() {
        int bodies = 1000;
        ArrayNode many = JsonNodeFactory.instance.arrayNode();
        IntStream.range(0, bodies).forEach(i -> many.add(body("stone")));
        Draft draft = NewLevel.draft().with("/bodies", many);
        assertThat(NewLevel.draft().toString()).as("loads the library's classes").isNotEmpty();
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
        int length = draft.toString().length();
        long taken = threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
        // The text grows by doubling; objects to go through a body's members are as long again.
        assertThat(taken).isLessThan(20L * length);
    }

    @Test
    void aNewLevelLacksOnlySomethingToDelete() {
        assertThat(LOADER.parse("new", NewLevel.draft().toString()).problems())
                .singleElement()
                .satisfies(problem -> assertThat(problem.message()).startsWith("E130"));
    }

    @Test
    void anEditLeavesTheDraftItCameFromAsItWas() {
        Draft before = NewLevel.draft();
        String text = before.toString();
        Item ball = before.item("/ball").orElseThrow();
        Draft after = before.with(ball.at(new Point(3, 4))).without("/rules/contactGrace");
        assertThat(before).hasToString(text);
        assertThat(after.at("/ball/x").asDouble()).isEqualTo(3);
        assertThat(after.at("/rules/contactGrace").isMissingNode()).isTrue();
    }

    @Test
    void bodiesGetIdsThatNobodyHas() {
        Draft draft = NewLevel.draft().plus(body("stone")).plus(body("stone"));
        assertThat(draft.items()).extracting(Item::id).contains("ledge", "stone1", "stone2");
        assertThat(draft.lastBody().pointer()).isEqualTo("/bodies/2");
    }

    @Test
    void whatClicksADeletedBodyIsNoSolutionAnyMore() {
        Draft draft = NewLevel.draft().plus(body("rigibo")).plus(body("rigibo"));
        Draft solved =
                Clicks.keep(
                        Clicks.keep(draft, solution("rigibo1", "rigibo2")), solution("rigibo2"));
        Draft less = solved.without(solved.item("/bodies/1").orElseThrow());
        assertThat(less.at("/solutions")).hasSize(1);
        assertThat(less.at("/solutions/0/clicks/0/body").asString()).isEqualTo("rigibo2");
    }

    /** A star of an id nobody has would be an error that the editor itself has made. */
    @Test
    void theStarFollowsABodyThatIsRenamedAndGoesWithIt() {
        Draft draft = NewLevel.draft().plus(body("rigibo")).plus(body("stone"));
        String clicks = "{\"clicks\": [{\"t\": 1, \"body\": \"rigibo1\"}]}";
        Draft starred =
                draft.with(
                        "/star",
                        JsonNodeFactory.instance
                                .objectNode()
                                .put("type", "avoid")
                                .put("body", "stone1")
                                .set("solution", JsonMapper.shared().readTree(clicks)));
        Draft renamed = Clicks.renamed(starred, "stone1", "pillar");
        assertThat(renamed.at("/star/body").asString()).isEqualTo("pillar");
        Draft other = Clicks.renamed(starred, "rigibo1", "box");
        assertThat(other.at("/star/solution/clicks/0/body").asString()).isEqualTo("box");
        for (Item body : List.of(starred.lastBody(), starred.item("/bodies/1").orElseThrow())) {
            assertThat(starred.without(body).at("/star").isMissingNode()).as(body.id()).isTrue();
        }
        Item ledge = starred.item("/bodies/0").orElseThrow();
        assertThat(starred.without(ledge).at("/star/type").asString()).isEqualTo("avoid");
    }

    @Test
    void aSolutionByTheSameClicksReplacesTheOneBefore() {
        Draft draft = Clicks.keep(Clicks.keep(NewLevel.draft(), solution("a")), solution("a"));
        assertThat(draft.at("/solutions")).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"[]", "4", "{\"format\": 3}", "{\"ball\": 3}", "{\"bodies\": {}}"})
    void whatIsNoLevelIsRefused(String text) {
        JsonNode document = parsed(text);
        assertThatThrownBy(() -> Draft.of(document)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void whatALevelLacksIsFilledIn() {
        assertThat(Draft.of(parsed("{}"))).isEqualTo(NewLevel.draft());
    }

    @Test
    void aTurnedItemKnowsWhereItsPointsAre() {
        Item plank =
                NewLevel.draft().item("/platform").orElseThrow().at(new Point(2, 1)).turnedTo(90);
        Point end = plank.toWorld(new Point(1, 0));
        assertThat(end.x()).isCloseTo(2, within(1e-12));
        assertThat(end.y()).isCloseTo(2, within(1e-12));
        assertThat(plank.contains(new Point(2, 1.9))).isTrue();
        assertThat(plank.contains(new Point(2.9, 1))).isFalse();
    }

    @Test
    void clockwiseCornersHaveTheSameShapeAsCounterClockwiseOnes() {
        List<Point> round = List.of(new Point(0, 0), new Point(3, 0), new Point(0, 3));
        List<Point> back = List.of(new Point(0, 3), new Point(3, 0), new Point(0, 0));
        for (List<Point> corners : List.of(round, back)) {
            Point centre = new Corners(corners).centre();
            assertThat(centre.x()).isCloseTo(1, within(1e-12));
            assertThat(centre.y()).isCloseTo(1, within(1e-12));
        }
    }

    @Test
    void aDentedPolygonCanBePointedAtButNotSimulated() {
        List<Point> dented =
                List.of(new Point(0, 0), new Point(4, 0), new Point(1, 1), new Point(0, 4));
        assertThat(new Corners(dented).shape()).isEmpty();
        assertThat(new Corners(dented).contains(new Point(0.5, 0.5))).isTrue();
        assertThat(new Corners(dented).contains(new Point(2, 2))).isFalse();
    }

    @Test
    void thingsOfAnySizeSnapFlush() {
        Item ball = NewLevel.draft().item("/ball").orElseThrow();
        Item odd = ball.formed(new Disc(0.325)).at(new Point(1.01, 2.02));
        assertThat(Grid.ON.snap(odd).place()).isEqualTo(new Point(1.025, 2.025));
    }

    private static tools.jackson.databind.node.ObjectNode body(String material) {
        return JsonNodeFactory.instance
                .objectNode()
                .put("x", 4.0)
                .put("y", 4.0)
                .put("material", material);
    }

    private static Solution solution(String... bodies) {
        return new Solution(Stream.of(bodies).map(body -> new Click(1, body)).toList());
    }

    private static JsonNode parsed(String text) {
        return LOADER.parse("test", text).document().orElseThrow();
    }
}

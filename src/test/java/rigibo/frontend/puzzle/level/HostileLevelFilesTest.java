package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.document.Problem;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Files of a megabyte or less that once took gigabytes, an hour, or a hundred thousand lines. */
class HostileLevelFilesTest {

    private static final int MOST_BYTES = 1_000_000;

    /** 64 bytes for each byte of the largest file. */
    private static final long MOST_ALLOCATED = 64L << 20;

    /** A hundred problems and the number of the rest. */
    private static final int MOST_TOLD = 101;

    private static final String BOX = "{\"type\": \"box\", \"w\": 1, \"h\": 1}";

    private final LevelLoader loader = new LevelLoader();

    private static String bodies(int count, IntFunction<String> body) {
        return LevelTexts.SOUND.replaceFirst(
                "(?s)\"bodies\": \\[.*?\n  \\]", "\"bodies\": [" + repeated(count, body) + "]");
    }

    private static String repeated(int count, IntFunction<String> part) {
        return IntStream.range(0, count).mapToObj(part).collect(Collectors.joining(","));
    }

    private static String box(int number) {
        return String.format(
                "{\"id\":\"b%d\",\"shape\":%s,\"x\":4,\"y\":7,\"material\":\"ice\"}", number, BOX);
    }

    private static String clicks(int solutions) {
        String click = "{\"t\": 1, \"body\": \"nobodyHasThisIdentifierInHere\"}";
        String solution = "{\"clicks\": [" + repeated(100, i -> click) + "]}";
        return bodies(500, HostileLevelFilesTest::apart)
                .replaceFirst(
                        "(?s)\"solutions\": .*",
                        "\"solutions\": [" + repeated(solutions, i -> solution) + "]}");
    }

    private static String apart(int number) {
        return String.format(
                "{\"id\":\"nobodyHasThisIdentifier%d\",\"shape\":%s,\"x\":%d,\"y\":%d,"
                        + "\"material\":\"ice\"}",
                number, BOX, 10 + 2 * (number % 25), 10 + 2 * (number / 25));
    }

    private static String duplicates() {
        return "{" + repeated(49_000, i -> "\"key" + i % 24_500 + "\":" + i) + "}";
    }

    static Stream<Arguments> hostile() {
        return Stream.of(
                Arguments.of(
                        "a long key with a long list",
                        "{\"" + "k".repeat(49_000) + "\": [" + repeated(400_000, i -> "1") + "]}"),
                Arguments.of(
                        "long keys within each other",
                        repeated(30, i -> "{\"" + "k".repeat(199) + "\":").replace(",", "")
                                + "["
                                + repeated(99_000, i -> "1")
                                + "]"
                                + "}".repeat(30)),
                Arguments.of("20000 empty bodies", bodies(20_000, i -> "{}")),
                Arguments.of("500 empty bodies", bodies(500, i -> "{}")),
                Arguments.of("500 coinciding bodies", bodies(500, HostileLevelFilesTest::box)),
                Arguments.of("500 bodies of one id", bodies(500, i -> box(0))),
                Arguments.of(
                        "500 coinciding polygons of 16 corners",
                        bodies(500, i -> box(i).replace(BOX, sixteenCorners()))),
                Arguments.of("5000 clicks on nobody", clicks(50)),
                Arguments.of(
                        "unknown members", "{" + repeated(49_000, i -> "\"k" + i + "\":1") + "}"),
                Arguments.of(
                        "unknown members of bodies",
                        bodies(499, i -> "{" + repeated(90, j -> "\"k" + j + "\":1") + "}")),
                Arguments.of("keys given twice", duplicates()),
                Arguments.of(
                        "effects",
                        LevelTexts.with("\"gravity\", ", repeated(40_000, i -> "1") + ",")),
                Arguments.of(
                        "titles",
                        LevelTexts.with(
                                "\"en\": \"Drop\",",
                                repeated(40_000, i -> "\"k" + i + "\":1") + ",")),
                Arguments.of(
                        "an id of many words", LevelTexts.with("drop", "a-".repeat(2_400) + "a")),
                Arguments.of("empty objects", "[" + repeated(330_000, i -> "{}") + "]"),
                Arguments.of("depth", "[".repeat(MOST_BYTES)),
                Arguments.of("a long text", "\"" + "a".repeat(MOST_BYTES - 2) + "\""),
                Arguments.of("a long number", "1" + "0".repeat(MOST_BYTES - 1)),
                Arguments.of("blanks", " ".repeat(MOST_BYTES)));
    }

    private static String sixteenCorners() {
        return "{\"type\":\"polygon\",\"points\":["
                + repeated(
                        16,
                        i ->
                                String.format(
                                        Locale.ROOT,
                                        "[%.3f,%.3f]",
                                        Math.cos(i * Math.PI / 8),
                                        Math.sin(i * Math.PI / 8)))
                + "]}";
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("hostile")
    void takesBoundedMemoryAndLines(String name, String text) {
        assertThat(text.length()).isLessThanOrEqualTo(MOST_BYTES);
        loader.parse("warm.json", LevelTexts.SOUND).problems();
        long before = allocated();
        List<Problem> problems = loader.parse("a.json", text).problems();
        long after = allocated();
        assertThat(problems).hasSizeBetween(1, MOST_TOLD);
        assertThat(after - before).as("bytes allocated").isLessThan(MOST_ALLOCATED);
    }

    private static long allocated() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        return threads.getThreadAllocatedBytes(Thread.currentThread().getId());
    }

    /** 500 bodies are 124,750 pairs; none can be deleted, and the solution clicks none of them. */
    @Test
    void countsWhatItDoesNotTell() {
        List<Problem> problems =
                loader.parse("a.json", bodies(500, HostileLevelFilesTest::box)).problems();
        assertThat(problems).hasSize(MOST_TOLD);
        assertThat(problems.get(MOST_TOLD - 1).message()).isEqualTo("… and 124,652 more");
    }

    @Test
    void stopsReadingAListThatIsTooLong() {
        assertThat(loader.parse("a.json", bodies(501, i -> "{}")).problems())
                .extracting(Problem::toString)
                .containsExactly("a.json:12:13: /bodies: must have 500 values or fewer, has 501");
    }

    @Test
    void showsControlCharactersOfKeysEscaped() {
        String text =
                LevelTexts.with(
                        "\"id\": \"drop\"", "\"id\": \"drop\", \"a\\n\\u001b[2J\\u202e\": 1");
        assertThat(loader.parse("a.json", text).problems())
                .extracting(Problem::toString)
                .containsExactly(
                        "a.json:3:39: /a\\n"
                                + "\\u001b[2J\\u202e: \"a\\n"
                                + "\\u001b[2J\\u202e\" is not known here");
    }
}

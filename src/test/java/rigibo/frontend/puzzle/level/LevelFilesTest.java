package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.document.Problem;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

class LevelFilesTest {

    @TempDir private Path folder;
    private final LevelLoader loader = new LevelLoader();

    private List<String> problems(Path file) {
        return loader.load(file).problems().stream()
                .map(problem -> problem.place() + " " + problem.message())
                .toList();
    }

    private Path file(byte[] content) throws IOException {
        return Files.write(folder.resolve("a.json"), content);
    }

    @Test
    void aMissingFileIsAProblemAndNoException() {
        assertThat(problems(folder.resolve("none.json")))
                .containsExactly("1:1 cannot be read: there is no such file");
    }

    @Test
    void aFolderIsNoLevel() {
        assertThat(problems(folder)).containsExactly("1:1 cannot be read: it is a folder");
    }

    @Test
    void aHugeFileIsNotReadToItsEnd() throws IOException {
        assertThat(problems(file(new byte[1_000_001])))
                .containsExactly("1:1 is larger than 1000000 bytes, the most we read");
    }

    @Test
    void otherEncodingsAreRefused() throws IOException {
        assertThat(problems(file("\"ä\"".getBytes(StandardCharsets.ISO_8859_1))))
                .containsExactly("1:1 is not UTF-8 text");
    }

    @Test
    void aByteOrderMarkDoesNoHarm() throws IOException {
        byte[] marked = ("\uFEFF" + LevelTexts.SOUND).getBytes(StandardCharsets.UTF_8);
        assertThat(problems(file(marked))).isEmpty();
    }

    static Stream<Arguments> malformed() {
        return Stream.of(
                Arguments.of("", "1:1 the file is empty"),
                Arguments.of("{\n  \"format\": 1,\n  \"id\": ?\n}", "3:9 not JSON: "),
                Arguments.of("{\"format\": 1", "1:13 not JSON: "),
                Arguments.of("{} {}", "1:4 not JSON: text after the end"),
                Arguments.of(
                        "[".repeat(100_000),
                        "1:33 more than we read: Document nesting depth (33) exceeds the maximum"
                                + " allowed (32)"));
    }

    @ParameterizedTest
    @MethodSource("malformed")
    void brokenJsonIsToldWhereItBreaks(String text, String begin) throws IOException {
        assertThat(problems(file(text.getBytes(StandardCharsets.UTF_8))))
                .singleElement()
                .asString()
                .startsWith(begin);
    }

    @Test
    void aKeyGivenTwiceIsToldWithBothPlaces() {
        String text = LevelTexts.with("\"y\": 2.7", "\"y\": 2.7, \"x\": 1");
        assertThat(loader.parse("a.json", text).problems())
                .extracting(Problem::toString)
                .containsExactly("a.json:10:32: /ball/x: \"x\" is given twice (first at 10:12)");
    }

    @Test
    void aNumberBeyondDoublesIsRefused() {
        String text = LevelTexts.with("\"y\": 2.7", "\"y\": 1e999");
        assertThat(loader.parse("a.json", text).problems())
                .extracting(Problem::toString)
                .containsExactly("a.json:10:27: /ball/y: the number 1e999 is too large");
    }

    @Test
    void aNumberBeyondWhatIsCountedInOnesIsToldOnce() {
        String text = LevelTexts.with("\"par\": 1", "\"par\": 1e308");
        assertThat(loader.parse("a.json", text).problems())
                .extracting(Problem::toString)
                .containsExactly("a.json:9:50: /rules/par: the number 1e308 is too large");
    }

    @Test
    void levelsAreSortedByWorldAndNumber() throws IOException {
        List<String> sorted = List.of("1-02-b.json", "1-10-a.json", "2-01-c.json");
        for (String name : List.of("2-01-c.json", "1-10-a.json", "1-02-b.json", "3.json")) {
            Files.createFile(folder.resolve(name));
        }
        List<Path> files = LevelShelf.filesIn(folder);
        assertThat(files).extracting(file -> file.getFileName().toString()).isEqualTo(sorted);
        assertThat(files).extracting(LevelShelf::world).containsExactly(1, 1, 2);
    }

    /** More levels would not fit on their page of the list. */
    @Test
    void aWorldHoldsTenLevelsAtMost() {
        Map<Integer, Long> counts =
                LevelShelf.files().stream()
                        .collect(Collectors.groupingBy(LevelShelf::world, Collectors.counting()));
        assertThat(counts).containsOnlyKeys(1, 2, 3, 4);
        assertThat(counts.values()).allMatch(count -> count <= 10);
    }

    @Test
    void theGamesOwnLevelsHaveTitleHintAndSolution() {
        for (Path file : LevelShelf.files()) {
            Level level = loader.load(file).level().orElseThrow();
            assertThat(level.title().byLanguage()).as(level.id()).containsKeys("en", "de");
            assertThat(level.hint().byLanguage()).as(level.id()).containsKeys("en", "de");
            assertThat(level.solutions()).as(level.id()).isNotEmpty();
            Star star = level.star().orElseThrow();
            assertThat(star.text().byLanguage()).as(level.id()).containsKeys("en", "de");
        }
    }

    @Test
    void theGamesOwnLevelsLoadWithoutAWarning() {
        assertThat(LevelShelf.files()).hasSizeGreaterThanOrEqualTo(12);
        for (Path file : LevelShelf.files()) {
            assertThat(loader.load(file).problems()).as(file.toString()).isEmpty();
        }
    }
}

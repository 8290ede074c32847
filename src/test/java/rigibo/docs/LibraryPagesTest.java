package rigibo.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.backend.setup.StepStage;
import rigibo.examples.JdkTool;
import rigibo.examples.Snippets;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** The pages for those who use the engine: their code compiles, and their sentences are short. */
class LibraryPagesTest {

    private static final Path DOCS = Path.of(System.getProperty("rigibo.home", ""), "docs");

    /** Pages whose pieces of code are bodies of methods. */
    private static final List<String> WITH_PIECES =
            List.of(
                    "choosing-an-accuracy.md",
                    "coming-from-box2d.md",
                    "coming-from-dyn4j.md",
                    "how-a-step-works.md");

    private static final int MOST_WORDS = 35;

    @TempDir private Path folder;

    @Test
    void everyPieceOfCodeCompiles() throws IOException {
        assumeTrue(JdkTool.isThere("javac"), "this Java has no compiler");
        List<String> pieces = new ArrayList<>();
        for (String name : WITH_PIECES) {
            pieces.addAll(Page.read(DOCS.resolve(name)).blocks("java"));
        }
        assertThat(pieces).hasSizeGreaterThan(8);
        JdkTool.Said said = Snippets.compile(folder, pieces);
        assertThat(said.status()).as("%s", said.words()).isZero();
    }

    @Test
    void noSentenceIsLong() throws IOException {
        List<Path> pages = new ArrayList<>();
        for (String name : List.of("../README.md", "features.md", "using.md")) {
            pages.add(DOCS.resolve(name));
        }
        WITH_PIECES.forEach(name -> pages.add(DOCS.resolve(name)));
        try (Stream<Path> chapters = Files.list(DOCS.resolve("tutorial"))) {
            chapters.filter(file -> file.toString().endsWith(".md")).forEach(pages::add);
        }
        for (Path page : pages) {
            assertThat(Page.read(page).sentences())
                    .as("sentences of %s", page)
                    .isNotEmpty()
                    .allSatisfy(
                            sentence ->
                                    assertThat(sentence.split("\\s+"))
                                            .as("%s", sentence)
                                            .hasSizeLessThanOrEqualTo(MOST_WORDS));
        }
    }

    @Test
    void theStepsPictureAndPageNameEveryStage() throws IOException {
        String page = Page.read(DOCS.resolve("how-a-step-works.md")).text();
        for (StepStage stage : StepStage.values()) {
            String name = stage.name().toLowerCase(Locale.ROOT);
            assertThat(StepPicture.svg()).contains(">" + name + "<");
            assertThat(page).contains("| " + name + " |");
        }
    }

    /** The table of what an accuracy costs is a line of the measured one. */
    @Test
    void theCostOfAnAccuracyIsTheMeasuredOne() throws IOException {
        Page choice = Page.read(DOCS.resolve("choosing-an-accuracy.md"));
        List<String> errors = choice.row("error, rad");
        List<String> times = choice.row("time of a step, µs");
        List<String> cells = new ArrayList<>();
        for (int i = 0; i < errors.size(); i++) {
            cells.add(errors.get(i) + " · " + times.get(i) + " µs");
        }
        assertThat(Page.read(DOCS.resolve("accuracy.md")).text())
                .contains(
                        "| R17 a pendulum that swings 100 times from 90° | "
                                + String.join(" | ", cells)
                                + " |");
    }
}

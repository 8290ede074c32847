package rigibo.docs.site;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.frontend.gallery.Exhibits;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The pages of the site, made from the checkout without Javadoc and game. */
class SiteTest {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    private static final Pattern LOADED = Pattern.compile("(?:src=|<link [^>]*href=)\"([^\"]*)\"");
    private static final Pattern LINK = Pattern.compile("<a [^>]*href=\"([^\"]*)\"");
    private static final Pattern ANCHOR = Pattern.compile(" id=\"([^\"]*)\"");

    @TempDir private static Path folder;

    @BeforeAll
    static void write() throws IOException {
        new Site(HOME, folder).write(0);
    }

    private static List<Path> files(Path of, String ending) throws IOException {
        try (Stream<Path> files = Files.walk(of)) {
            return files.filter(file -> file.toString().endsWith(ending)).toList();
        }
    }

    private static Set<String> found(Pattern pattern, Path page) throws IOException {
        return pattern.matcher(Files.readString(page))
                .results()
                .map(found -> found.group(1))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    @Test
    void everyPageOfDocsIsThere() throws IOException {
        for (Path file : files(HOME.resolve("docs"), ".md")) {
            assertThat(folder.resolve(Address.ofFile(HOME.relativize(file)))).exists();
        }
        assertThat(folder.resolve("index.html")).content().contains("two-storeys.gif");
    }

    @Test
    void everyLinkAndEveryAnchorIsThere() throws IOException {
        for (Path page : files(folder, ".html")) {
            for (String link : found(LINK, page)) {
                if (!link.startsWith("https://")) {
                    requireThere(page, link);
                }
            }
        }
    }

    private static void requireThere(Path page, String link) throws IOException {
        String[] parts = link.split("#", 2);
        Path to = parts[0].isEmpty() ? page : page.resolveSibling(parts[0]).normalize();
        assertThat(to).as("linked in %s", folder.relativize(page)).isRegularFile();
        if (parts.length > 1) {
            assertThat(found(ANCHOR, to)).as("of %s", folder.relativize(page)).contains(parts[1]);
        }
    }

    @Test
    void whatPagesShowIsInTheSite() throws IOException {
        for (Path page : files(folder, ".html")) {
            assertThat(found(LOADED, page))
                    .as("shown by %s", folder.relativize(page))
                    .allSatisfy(link -> assertThat(page.resolveSibling(link)).isRegularFile());
            assertThat(Files.readString(page)).doesNotContain("<script", "<iframe", " style=");
        }
        String style = Files.readString(folder.resolve("site.css"));
        assertThat(style).doesNotContain("//", "@import");
    }

    @Test
    void everyExhibitHasAPictureAndItsSource() throws IOException {
        String cards = Files.readString(folder.resolve("gallery/index.html"));
        assertThat(Exhibits.all())
                .hasSizeGreaterThan(100)
                .allSatisfy(
                        found -> {
                            assertThat(cards)
                                    .contains(found.name() + ".html", found.name() + ".svg");
                            assertThat(folder.resolve(GalleryPages.page(found.name())))
                                    .content()
                                    .contains(found.type().getSimpleName(), found.name() + ".svg");
                        });
        assertThat(found(LINK, folder.resolve("docs/samples.html")))
                .contains("../gallery/barrel.html");
    }

    @Test
    void accuracyIsPlotsThenSentencesThenTables() throws IOException {
        String page = Files.readString(folder.resolve("docs/accuracy.html"));
        List<String> order =
                List.of(
                        "problems/R1.svg",
                        "problems/R20.svg",
                        "DRAFT errs by",
                        "id=\"the-figures\"",
                        "Each cell gives",
                        "<th>problem</th>");
        assertThat(order.stream().map(page::indexOf)).isSorted().allMatch(place -> place > 0);
        assertThat(page.lastIndexOf("<h")).isLessThan(page.indexOf("<th>problem</th>"));
    }

    @Test
    void sentencesAreReadAsReadings() {
        String section =
                """
                - DRAFT errs by 1.9 × 10⁻¹⁵ at 290 ns a step, GAME errs by 0 at 3.01 ms a step.
                - JBox2D 2.2.1.1: default fails (disc 0 left its room) at 2.72 µs a step, \
                finer errs by 0.10 at 1.80 µs a step; dyn4j 6.0.0: default errs by 86 at 4 s a step; \
                Box2D 3.2.0: 8 substeps errs by 2 at 3 ns a step.
                """;
        assertThat(Reading.in(section))
                .containsExactly(
                        new Reading("", "DRAFT", 1.9e-15, 290 * 1e-9),
                        new Reading("", "GAME", 0, 3.01 * 1e-3),
                        new Reading("JBox2D 2.2.1.1", "default", Double.NaN, 2.72 * 1e-6),
                        new Reading("JBox2D 2.2.1.1", "finer", 0.1, 1.8 * 1e-6),
                        new Reading("dyn4j 6.0.0", "default", 86, 4),
                        new Reading("Box2D 3.2.0", "8 substeps", 2, 3 * 1e-9));
    }

    @Test
    void everyProblemOfThePageHasAllPresets() throws IOException {
        AccuracyPage page = new AccuracyPage(Files.readString(HOME.resolve(AccuracyPage.FILE)));
        assertThat(page.readings()).hasSizeGreaterThanOrEqualTo(20);
        assertThat(page.readings().values())
                .allSatisfy(
                        readings ->
                                assertThat(readings.stream().filter(Reading::isOurs))
                                        .extracting(Reading::setting)
                                        .containsExactly("DRAFT", "GAME", "FINE", "EXACT"));
    }
}

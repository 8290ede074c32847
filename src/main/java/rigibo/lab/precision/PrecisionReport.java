package rigibo.lab.precision;

import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.Png;
import rigibo.lab.plot.PngLetters;
import rigibo.lab.problem.Problem;
import rigibo.lab.report.Html;
import rigibo.lab.report.Section;
import rigibo.lab.report.Table;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The report on what accuracy costs in time. */
final class PrecisionReport {

    private static final String CELLS = "Each cell gives the error and the time of a step.";

    private final List<Point> points;
    private final List<Asked> asked;
    private final List<Section> more;
    private final Environment environment;
    private final PrecisionSentences sentences;
    private final PrecisionTables tables;

    /**
     * A report.
     *
     * @param points in the order of the settings; the first of another engine is at its defaults,
     *     its others are finer
     * @param problems the problems to report, in their order; those without points are left out
     * @param more sections after the problems
     */
    PrecisionReport(
            List<Point> points,
            List<Problem> problems,
            List<Section> more,
            Environment environment) {
        this.points = List.copyOf(points);
        this.more = List.copyOf(more);
        this.environment = environment;
        asked = Asked.of(problems, points);
        sentences = new PrecisionSentences(asked);
        tables = new PrecisionTables(asked);
    }

    /** Writes tables, figures and the page into a directory that exists. */
    void write(Path directory) throws IOException {
        Files.write(directory.resolve("results.csv"), PointsCsv.results(points));
        Files.write(directory.resolve("timing.csv"), PointsCsv.timing(points));
        Files.writeString(directory.resolve("env.json"), environment.json());
        List<Section> sections = sections();
        for (Section section : sections) {
            if (!section.figures().isEmpty()) {
                draw(directory, section.name(), section.figures().get(0));
            }
        }
        Files.writeString(
                directory.resolve("index.html"),
                Html.page("What accuracy costs in time", first(), sections, environment.words()));
    }

    private List<String> first() {
        List<String> first = new ArrayList<>(sentences.main());
        if (PngLetters.find().isEmpty()) {
            first.add("This machine has no letters to draw with, so there are no PNG files.");
        }
        return first;
    }

    private static void draw(Path directory, String name, Drawing drawing) throws IOException {
        Files.writeString(directory.resolve(name + ".svg"), drawing.svg());
        Optional<PngLetters> letters = PngLetters.find();
        if (letters.isPresent()) {
            Png png = new Png(letters.get(), drawing.width(), drawing.height());
            drawing.on(png);
            png.write(directory.resolve(name + ".png"));
        }
    }

    private List<Section> sections() {
        List<Section> sections = new ArrayList<>();
        sections.add(new Section("tables", "All in numbers", List.of(CELLS), List.of(), numbers()));
        asked.forEach(one -> sections.add(section(one)));
        sections.addAll(more);
        return sections;
    }

    private List<Table> numbers() {
        return tables.hasEngines()
                ? List.of(tables.presets(), tables.engines())
                : List.of(tables.presets());
    }

    private Section section(Asked one) {
        List<Drawing> figures =
                WorkPrecisionFigure.isOf(one)
                        ? List.of(
                                new WorkPrecisionFigure(one, FigureSize.WIDE).drawing(),
                                new WorkPrecisionFigure(one, FigureSize.NARROW).drawing())
                        : List.of();
        return new Section(
                one.problem().id(),
                one.problem().id() + ", " + one.problem().title(),
                sentences.of(one),
                figures,
                List.of());
    }

    /** The main findings, a sentence per line. */
    List<String> sentences() {
        return sentences.main();
    }

    /** The measured part of a page of Markdown. */
    String markdown() {
        StringBuilder page = new StringBuilder();
        page.append(environment.words()).append(" By `").append(environment.command());
        page.append("`.\n\n");
        sentences.main().forEach(sentence -> page.append(sentence).append("\n\n"));
        page.append(CELLS).append("\n\n");
        numbers().forEach(table -> page.append(table.markdown()).append("\n"));
        for (Asked one : asked) {
            page.append(
                    String.format(
                            Locale.ROOT,
                            "### %s, %s%n%nError: %s.%n%n",
                            one.problem().id(),
                            one.problem().title(),
                            one.problem().error()));
            sentences.of(one).forEach(words -> page.append("- ").append(words).append('\n'));
            page.append('\n');
        }
        for (Section section : more) {
            page.append("### ").append(section.title()).append("\n\n");
            section.sentences().forEach(words -> page.append("- ").append(words).append('\n'));
            page.append('\n');
        }
        return page.toString();
    }
}

package rigibo.docs.site;

import org.commonmark.ext.gfm.tables.TableBlock;
import org.commonmark.node.Heading;
import org.commonmark.node.HtmlBlock;
import org.commonmark.node.Node;
import org.commonmark.node.Text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** The page on accuracy: plots of all problems first, then its sentences, then the large tables. */
final class AccuracyPage {

    static final Path FILE = Path.of("docs/accuracy.md");

    /** Where its plots are. */
    private static final Path PLOTS = Path.of("docs/pictures/problems");

    /** A problem's title, and what is told of it. */
    private static final Pattern PROBLEM =
            Pattern.compile("^### ((R\\d+), .*)\\n((?:(?!^#).*\\n)*)", Pattern.MULTILINE);

    /** The line that names a problem's error. */
    private static final Pattern ERROR = Pattern.compile("^Error: (.*)\\.$", Pattern.MULTILINE);

    private static final String MEASURED = "What was measured";

    private final List<MatchResult> problems;

    /** The page made of its Markdown. */
    AccuracyPage(String text) {
        problems = PROBLEM.matcher(text).results().toList();
    }

    /** The measurements, by the problem's short name. */
    Map<String, List<Reading>> readings() {
        Map<String, List<Reading>> all = new LinkedHashMap<>();
        problems.forEach(found -> all.put(found.group(2), Reading.in(found.group(3))));
        return all;
    }

    /** Writes the plots into the site. */
    void writePlots(Path folder) throws IOException {
        Path plots = folder.resolve(PLOTS);
        Files.createDirectories(plots);
        for (Map.Entry<String, List<Reading>> problem : readings().entrySet()) {
            Files.writeString(
                    plots.resolve(problem.getKey() + ".svg"),
                    WorkPrecision.svg(problem.getValue()));
        }
        for (WorkPrecision.Look look : WorkPrecision.Look.values()) {
            Files.writeString(plots.resolve(look.name() + ".svg"), look.legend());
        }
    }

    /** Puts the plots first and the large tables last. */
    void arrange(Node document) {
        HtmlBlock figure = new HtmlBlock();
        figure.setLiteral(figure());
        Markdown.heading(document, 1).insertAfter(figure);
        Heading figures = new Heading();
        figures.setLevel(2);
        figures.appendChild(new Text("The figures"));
        List<Node> tables = tables(document);
        document.appendChild(figures);
        tables.forEach(document::appendChild);
    }

    private String figure() {
        StringBuilder html = new StringBuilder("<figure class=\"plots\">\n<p class=\"legend\">");
        for (WorkPrecision.Look look : WorkPrecision.Look.values()) {
            html.append("<span>").append(Html.picture(link(look.name()), ""));
            html.append(' ').append(look.words).append("</span> ");
        }
        html.append("</p>\n<div class=\"small\">\n");
        for (MatchResult problem : problems) {
            String title = Html.escaped(problem.group(1));
            MatchResult error = ERROR.matcher(problem.group(3)).results().findFirst().orElseThrow();
            html.append("<div><b>").append(title).append("</b>");
            html.append(Html.picture(link(problem.group(2)), "Error against time: " + title));
            html.append("<span>").append(Html.escaped(error.group(1))).append("</span></div>\n");
        }
        html.append(
                "</div>\n"
                        + "<figcaption>Error, upwards, against the time of a step, for each"
                        + " problem; ");
        html.append(
                "less of both is better. Our line goes from DRAFT to EXACT; other engines are ");
        html.append(
                "shown as they come and with finer steps. Errors below 10⁻¹⁶ are drawn there, ");
        html.append("and a cross is a failure.</figcaption>\n</figure>\n");
        return html.toString();
    }

    private static String link(String name) {
        return Address.link(Address.ofFile(FILE), PLOTS.resolve(name + ".svg"));
    }

    /** Those right under the heading of what was measured, each with the sentence before it. */
    private static List<Node> tables(Node document) {
        List<Node> found = new ArrayList<>();
        Node node = Markdown.heading(document, 2);
        while (!(node instanceof Heading heading && isMeasured(heading))) {
            node = node.getNext();
        }
        for (node = node.getNext(); !(node instanceof Heading); node = node.getNext()) {
            boolean leads = node.getNext() instanceof TableBlock;
            if (node instanceof TableBlock || leads) {
                found.add(node);
            }
        }
        return found;
    }

    private static boolean isMeasured(Heading heading) {
        return heading.getFirstChild() instanceof Text text && text.getLiteral().equals(MEASURED);
    }
}

package rigibo.lab.report;

import rigibo.lab.plot.Drawing;

import java.util.List;
import java.util.stream.Collectors;

/**
 * A page in one file. It opens without a network, needs no script, and is readable on a phone and
 * on paper.
 */
public final class Html {

    private static final String HEAD =
            """
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <link rel="icon" href="data:,">
            <title>%1$s</title>
            <style>
            :root { color: #222; background: #fff; }
            body { font: 17px/1.55 system-ui, "DejaVu Sans", sans-serif; margin: 0 auto;
                   max-width: 960px; padding: 24px 20px 64px; }
            h1 { font-size: 2rem; line-height: 1.2; margin: 24px 0 8px; }
            h2 { font-size: 1.35rem; line-height: 1.3; margin: 64px 0 8px; }
            p { margin: 8px 0; max-width: 44em; }
            ul { margin: 8px 0; padding-left: 1.2em; max-width: 44em; }
            nav a { color: #0072B2; margin-right: 14px; text-decoration: none;
                    white-space: nowrap; }
            figure { margin: 24px 0; }
            figure svg { display: block; height: auto; width: 100%%; }
            .narrow { display: none; }
            .table { margin: 20px 0; overflow-x: auto; }
            table { border-collapse: collapse; font-size: 0.85rem;
                    font-variant-numeric: tabular-nums; }
            th, td { border-bottom: 1px solid #ddd; padding: 5px 12px 5px 0; text-align: right;
                     vertical-align: top; }
            td span { display: block; white-space: nowrap; }
            td span + span { color: #666; }
            th:first-child, td:first-child { text-align: left; min-width: 5em; }
            td:first-child span { white-space: normal; }
            th { color: #666; font-weight: 600; }
            footer { border-top: 1px solid #ddd; color: #666; font-size: 0.85rem;
                     margin-top: 64px; padding-top: 16px; }
            @media (max-width: 640px) {
              body { font-size: 16px; padding: 12px 14px 48px; }
              h1 { font-size: 1.5rem; }
              th, td { padding-right: 8px; }
              .wide { display: none; }
              .narrow { display: block; }
            }
            @media print {
              body { font-size: 10pt; max-width: none; padding: 0; }
              nav { display: none; }
              table { font-size: 7.5pt; }
              figure, tr { break-inside: avoid; }
              h2 { break-after: avoid; }
            }
            </style>
            </head>
            <body>
            <h1>%1$s</h1>
            """;

    private Html() {}

    /** The page. */
    public static String page(
            String title, List<String> first, List<Section> sections, String foot) {
        String parts = sections.stream().map(Html::part).collect(Collectors.joining());
        String ways =
                sections.stream()
                        .map(
                                section ->
                                        String.format(
                                                "<a href=\"#%s\">%s</a>",
                                                section.name(), escaped(section.name())))
                        .collect(Collectors.joining("\n"));
        return String.format(HEAD, escaped(title))
                + sentences(first)
                + "<nav><p>"
                + ways
                + "</p></nav>\n"
                + parts
                + "<footer><p>"
                + escaped(foot)
                + "</p></footer>\n</body>\n</html>\n";
    }

    private static String part(Section section) {
        StringBuilder part = new StringBuilder();
        part.append(
                String.format(
                        "<section id=\"%s\">%n<h2>%s</h2>%n",
                        section.name(), escaped(section.title())));
        part.append(sentences(section.sentences()));
        List<Drawing> figures = section.figures();
        for (int i = 0; i < figures.size(); i++) {
            String kind = figures.size() == 1 ? "" : i == 0 ? "wide" : "narrow";
            part.append(
                    String.format(
                            "<figure class=\"%s\" role=\"img\" aria-label=\"%s\">%n%s</figure>%n",
                            kind, escaped(section.title()), figures.get(i).svg()));
        }
        section.tables().forEach(table -> part.append(table.html()));
        return part.append("</section>\n").toString();
    }

    private static String sentences(List<String> sentences) {
        return sentences.stream()
                .map(sentence -> "<p>" + escaped(sentence) + "</p>\n")
                .collect(Collectors.joining());
    }

    static String escaped(String words) {
        return words.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}

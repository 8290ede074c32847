package rigibo.docs.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The common parts of all pages: head, links to the other pages, foot. */
final class Layout {

    /** From so many sections on, a page begins with a list of them. */
    private static final int MANY_SECTIONS = 4;

    private static final Pattern SECTION = Pattern.compile("<h2 id=\"(.*?)\">(.*?)</h2>");

    private final Path folder;
    private final Map<String, Path> ways = new LinkedHashMap<>();

    /** Writes pages into a folder. */
    Layout(Path folder) {
        this.folder = folder;
    }

    /** Names a page that can be reached from every other. */
    void way(String name, Path page) {
        ways.put(name, page);
    }

    /** Writes a page. */
    void write(Path page, String title, String body) throws IOException {
        Path file = folder.resolve(page);
        Files.createDirectories(file.getParent());
        Files.writeString(file, html(page, title, body));
    }

    private String html(Path page, String title, String body) {
        boolean isFirst = page.equals(Path.of("index.html"));
        return """
        <!doctype html>
        <html lang="en">
        <head>
        <meta charset="utf-8">
        <meta name="viewport" content="width=device-width, initial-scale=1">
        <meta name="color-scheme" content="light dark">
        <title>%s</title>
        <link rel="icon" href="%s">
        <link rel="stylesheet" href="%s">
        </head>
        <body>
        <header>
        <a class="home" href="%s">RigiBo</a>
        <nav aria-label="Site">%s</nav>
        </header>
        <div class="page%s">
        %s<main>
        %s</main>
        </div>
        <footer>RigiBo is under the MIT licence, its fonts are under the SIL Open Font License.</footer>
        </body>
        </html>
        """
                .formatted(
                        Html.escaped(isFirst ? title : title + " · RigiBo"),
                        Address.link(page, Path.of("icon.svg")),
                        Address.link(page, Path.of("site.css")),
                        Address.link(page, Path.of("index.html")),
                        ways(page),
                        isFirst ? " first" : "",
                        isFirst ? "" : sections(body),
                        body);
    }

    private String ways(Path page) {
        return ways.entrySet().stream()
                .map(
                        way -> {
                            String link = Address.link(page, way.getValue());
                            String name = Html.escaped(way.getKey());
                            boolean isHere = way.getValue().equals(page);
                            return isHere
                                    ? "<a aria-current=\"page\" href=\""
                                            + link
                                            + "\">"
                                            + name
                                            + "</a>"
                                    : Html.link(link, name);
                        })
                .collect(Collectors.joining(" "));
    }

    private static String sections(String body) {
        String links =
                SECTION.matcher(body)
                        .results()
                        .map(
                                found ->
                                        "<li>"
                                                + Html.link("#" + found.group(1), found.group(2))
                                                + "</li>\n")
                        .collect(Collectors.joining());
        long count = SECTION.matcher(body).results().count();
        return count < MANY_SECTIONS
                ? ""
                : "<nav class=\"sections\" aria-label=\"This page\"><ul>\n"
                        + links
                        + "</ul></nav>\n";
    }
}

package rigibo.lab.report;

import java.util.List;
import java.util.stream.Collectors;

/**
 * Rows under a head, for two kinds of page.
 *
 * @param head of the columns
 * @param rows each as long as the head
 */
public record Table(List<String> head, List<List<String>> rows) {

    /** As Markdown; numbers, which are all columns but the first, to the right. */
    public String markdown() {
        String rule = "|---" + "|---:".repeat(head.size() - 1) + "|";
        String body = rows.stream().map(Table::line).collect(Collectors.joining("\n"));
        return line(head) + "\n" + rule + "\n" + body + "\n";
    }

    private static String line(List<String> cells) {
        return "| " + String.join(" | ", cells) + " |";
    }

    /** As HTML. */
    public String html() {
        String body =
                rows.stream()
                        .map(row -> "<tr>" + cells("td", row) + "</tr>")
                        .collect(Collectors.joining("\n"));
        return "<div class=\"table\"><table>\n<thead><tr>"
                + cells("th", head)
                + "</tr></thead>\n<tbody>\n"
                + body
                + "\n</tbody></table></div>\n";
    }

    private static String cells(String tag, List<String> cells) {
        return cells.stream()
                .map(cell -> "<" + tag + ">" + Html.escaped(cell) + "</" + tag + ">")
                .collect(Collectors.joining());
    }
}

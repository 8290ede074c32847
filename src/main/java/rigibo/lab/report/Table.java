package rigibo.lab.report;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Rows under a head, for two kinds of page.
 *
 * @param head of the columns
 * @param rows each as long as the head
 */
public record Table(List<String> head, List<List<String>> rows) {

    /** Between two amounts in a cell; on a page of HTML they stand below each other. */
    public static final String BESIDE = " · ";

    /** As Markdown; numbers, which are all columns but the first, to the right. */
    public String markdown() {
        String rule = "|---" + "|---:".repeat(head.size() - 1) + "|";
        String body = rows.stream().map(Table::line).collect(Collectors.joining("\n"));
        return line(head) + "\n" + rule + "\n" + body + "\n";
    }

    private static String line(List<String> cells) {
        return "| " + String.join(" | ", cells) + " |";
    }

    /** As lines for a terminal, columns padded with blanks; numbers to the right. */
    public List<String> text() {
        int[] widths = new int[head.size()];
        for (int i = 0; i < widths.length; i++) {
            int column = i;
            widths[i] =
                    Stream.concat(Stream.of(head), rows.stream())
                            .mapToInt(row -> row.get(column).length())
                            .max()
                            .orElse(0);
        }
        return Stream.concat(Stream.of(head), rows.stream())
                .map(row -> padded(row, widths).stripTrailing())
                .toList();
    }

    private static String padded(List<String> cells, int[] widths) {
        StringBuilder line = new StringBuilder();
        for (int i = 0; i < widths.length; i++) {
            String blanks = " ".repeat(widths[i] - cells.get(i).length());
            line.append(i == 0 ? cells.get(i) + blanks : "  " + blanks + cells.get(i));
        }
        return line.toString();
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
                .map(cell -> "<" + tag + ">" + amounts(cell) + "</" + tag + ">")
                .collect(Collectors.joining());
    }

    private static String amounts(String cell) {
        return Stream.of(cell.split(BESIDE))
                .map(amount -> "<span>" + Html.escaped(amount) + "</span>")
                .collect(Collectors.joining());
    }
}

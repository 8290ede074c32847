package rigibo.lab.report;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A table, for a terminal and for two kinds of page.
 *
 * @param head of the columns
 * @param rows each as long as the head
 */
public record Table(List<String> head, List<List<String>> rows) {

    /** The separator between two amounts in a cell; in HTML they stand below each other. */
    public static final String BESIDE = " · ";

    /** The table in Markdown; all columns but the first hold numbers and are right-aligned. */
    public String markdown() {
        String rule = "|---" + "|---:".repeat(head.size() - 1) + "|";
        String body = rows.stream().map(Table::line).collect(Collectors.joining("\n"));
        return line(head) + "\n" + rule + "\n" + body + "\n";
    }

    private static String line(List<String> cells) {
        return "| " + String.join(" | ", cells) + " |";
    }

    /** The lines for a terminal, with padded columns and right-aligned numbers. */
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

    /** The table in HTML. */
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

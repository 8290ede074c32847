package rigibo.lab.report;

import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Lines of comma-separated values (RFC 4180). */
public final class Csv {

    private Csv() {}

    /** One line without its line break; cells that contain separators are quoted. */
    public static String line(Object... cells) {
        return Stream.of(cells).map(cell -> quoted("" + cell)).collect(Collectors.joining(","));
    }

    private static String quoted(String cell) {
        boolean isPlain = cell.chars().noneMatch(letter -> ",\"\r\n".indexOf(letter) >= 0);
        return isPlain ? cell : '"' + cell.replace("\"", "\"\"") + '"';
    }
}

package rigibo.docs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The table of the architecture's page that tells how many lines each room has. */
final class RoomSizes {

    static final String PAGE = "docs/architecture.md";

    private static final String HEAD = "| room | lines |";

    /** Lines to which sizes are rounded. */
    private static final int HUNDRED = 100;

    private RoomSizes() {}

    /** A row of the table. */
    record Size(String room, long lines, String delivers) {

        static Size of(String row) {
            String[] columns = row.split("\\s*\\|\\s*");
            long lines = Long.parseLong(columns[2].replace(",", ""));
            return new Size(columns[1].replace("`", ""), lines, columns[3]);
        }

        private String row() {
            return String.format(Locale.ROOT, "| `%s` | %,d | %s |", room, lines, delivers);
        }

        /** How many lines the room has now. */
        long count(Path home) {
            String parent = room.startsWith("src/") ? "" : "src/main/java/rigibo";
            try (Stream<Path> files = Files.walk(home.resolve(parent).resolve(room))) {
                return files.filter(file -> file.toString().endsWith(".java"))
                        .mapToLong(RoomSizes::linesOf)
                        .sum();
            } catch (IOException broken) {
                throw new UncheckedIOException(broken);
            }
        }

        private Size counted(Path home) {
            return new Size(room, Math.round(count(home) / (double) HUNDRED) * HUNDRED, delivers);
        }
    }

    private static long linesOf(Path file) {
        try (Stream<String> lines = Files.lines(file)) {
            return lines.count();
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    static List<Size> told(Path home) throws IOException {
        return Files.readString(home.resolve(PAGE))
                .lines()
                .dropWhile(line -> !line.startsWith(HEAD))
                .skip(2)
                .takeWhile(line -> line.startsWith("|"))
                .map(Size::of)
                .toList();
    }

    /** The page with every room counted anew. */
    static String page(Path home) throws IOException {
        List<Size> told = told(home);
        String page = Files.readString(home.resolve(PAGE));
        return page.replace(table(told), table(told.stream().map(it -> it.counted(home)).toList()));
    }

    private static String table(List<Size> sizes) {
        return sizes.stream().map(Size::row).collect(Collectors.joining("\n"));
    }
}

package rigibo.frontend.document;

import java.nio.file.Path;
import java.util.List;

/** Stands in for packs, files of several entries; a page has none. */
public final class Pack {

    private Pack() {}

    /**
     * An entry.
     *
     * @param name in messages
     * @param text its content
     */
    public record Entry(String name, String text) {}

    /** Whether a file is a pack; never true. */
    public static boolean is(Path place) {
        return false;
    }

    /** Reads no entries, since there is no such file. */
    public static List<Entry> read(Path place, List<Problem> problems) {
        return List.of();
    }
}

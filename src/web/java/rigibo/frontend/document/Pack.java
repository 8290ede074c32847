package rigibo.frontend.document;

import java.nio.file.Path;
import java.util.List;

/** Files in one, of which a page knows no kind. */
public final class Pack {

    private Pack() {}

    /**
     * One of them.
     *
     * @param name as messages call it
     * @param text its content
     */
    public record Entry(String name, String text) {}

    /** Whether a file is one. */
    public static boolean is(Path place) {
        return false;
    }

    /** None, as there is no such file. */
    public static List<Entry> read(Path place, List<Problem> problems) {
        return List.of();
    }
}

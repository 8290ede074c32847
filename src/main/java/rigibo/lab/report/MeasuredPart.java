package rigibo.lab.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The part of a page of Markdown that a command writes: all below its heading, which is the last of
 * the page. What stands above is written by hand and stays.
 */
public final class MeasuredPart {

    private static final String HEADING = "## What was measured\n\n";

    private MeasuredPart() {}

    /**
     * Writes it anew, with its heading where the page has none.
     *
     * @param page made where there is none
     * @param markdown below the heading
     */
    public static void write(Path page, String markdown) throws IOException {
        String text = Files.exists(page) ? Files.readString(page) : "";
        int end = text.indexOf(HEADING);
        String byHand = end < 0 ? text : text.substring(0, end);
        Files.writeString(page, byHand + HEADING + markdown);
    }
}

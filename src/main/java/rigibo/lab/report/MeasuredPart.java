package rigibo.lab.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The part of a Markdown page that a command writes: all below its heading, which is the last one
 * of the page. The text above is written by hand and kept.
 */
public final class MeasuredPart {

    private static final String HEADING = "## What was measured\n\n";

    private MeasuredPart() {}

    /**
     * Rewrites the part, and adds its heading if the page has none.
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

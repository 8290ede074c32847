package rigibo.web.game;

import org.teavm.jso.JSBody;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The files of the page in one text: for each a line with its name and its number of characters,
 * then the characters.
 */
public final class Brought {

    private Brought() {}

    /** Writes them into a folder in memory, where the game looks for them. */
    public static void unpackTo(Path folder) throws IOException {
        String all = text();
        int at = 0;
        while (at < all.length()) {
            int end = all.indexOf('\n', at);
            int gap = all.indexOf(' ', at);
            Path file = folder.resolve(all.substring(at, gap));
            int length = Integer.parseInt(all.substring(gap + 1, end));
            Files.createDirectories(file.getParent());
            Files.writeString(file, all.substring(end + 1, end + 1 + length));
            at = end + 1 + length;
        }
    }

    @JSBody(script = "return window.rigiboFiles;")
    private static native String text();
}

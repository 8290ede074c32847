package rigibo.web.build;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.zip.CRC32;

/**
 * Writes the script that stores the page's files in the browser, so that it opens without a
 * network.
 */
final class Offline {

    /** Files that the game loads; the page itself is loaded by its folder. */
    private static final List<String> FILES =
            List.of(
                    "index.html",
                    "game.css",
                    "game.js",
                    "aside.js",
                    "game.wasm",
                    "game-functions.js",
                    "runtime.js",
                    "files.txt",
                    "words.ttf",
                    "numbers.ttf",
                    "icon.svg",
                    "manifest.webmanifest");

    private Offline() {}

    /** Writes the script; a page with other files is another version. */
    static void write(Path folder) throws IOException {
        CRC32 sum = new CRC32();
        for (String file : FILES) {
            sum.update(Files.readAllBytes(folder.resolve(file)));
        }
        String names =
                FILES.stream().map(name -> "'" + name + "'").collect(Collectors.joining(", "));
        try (InputStream template = Offline.class.getResourceAsStream("/web/offline.js")) {
            String text = new String(template.readAllBytes(), StandardCharsets.UTF_8);
            Files.writeString(
                    folder.resolve("offline.js"),
                    text.replace("{files}", names)
                            .replace("{version}", Long.toHexString(sum.getValue())));
        }
    }
}

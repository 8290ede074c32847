package rigibo.web.build;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * Chromium, or a browser of its kind, on this machine, started without a window and with a profile
 * of its own.
 */
final class Browser implements PageReader {

    private static final List<String> NAMES =
            List.of("chromium", "chromium-browser", "google-chrome");

    private static final int MOST_MINUTES = 10;

    private final Path program;

    private Browser(Path program) {
        this.program = program;
    }

    /** The first that is on the path, if there is any. */
    static Optional<Browser> find() {
        return OnPath.first(NAMES).map(Browser::new);
    }

    @Override
    public String read(LocalServer server, String name) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("rigibo-browser");
        Path page = folder.resolve("page.html");
        Process process =
                new ProcessBuilder(
                                program.toString(),
                                "--headless",
                                "--no-sandbox",
                                "--disable-gpu",
                                "--disable-background-networking",
                                "--disable-component-update",
                                "--disable-sync",
                                "--user-data-dir=" + folder.resolve("profile"),
                                "--virtual-time-budget=60000",
                                "--dump-dom",
                                server.address(name))
                        .redirectOutput(page.toFile())
                        .redirectError(folder.resolve("complaints").toFile())
                        .start();
        if (!process.waitFor(MOST_MINUTES, TimeUnit.MINUTES)) {
            process.destroyForcibly();
            throw new IOException(program + " did not end within " + MOST_MINUTES + " minutes");
        }
        return Files.readString(page, StandardCharsets.UTF_8);
    }

    @Override
    public String toString() {
        return program.getFileName().toString();
    }
}

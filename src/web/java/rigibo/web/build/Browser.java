package rigibo.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Chromium, or a browser based on it, on this machine, headless and with a profile of its own. */
final class Browser implements PageReader {

    private static final List<String> NAMES =
            List.of("chromium", "chromium-browser", "google-chrome");

    /**
     * Longest run of a page, min: the longest programs take a quarter of an hour on an idle
     * machine.
     */
    private static final int MOST_MINUTES = 60;

    /** Most looks for a browser that is starting. */
    private static final int MOST_TRIES = 600;

    private static final int TRY_MILLIS = 100;

    private final Path program;

    private Browser(Path program) {
        this.program = program;
    }

    /** The first browser on the path; empty if there is none. */
    static Optional<Browser> find() {
        return OnPath.first(NAMES).map(Browser::new);
    }

    @Override
    public String read(LocalServer server, String page) throws IOException, InterruptedException {
        Window window = open(server.address(page));
        try {
            return server.said().get(MOST_MINUTES, TimeUnit.MINUTES);
        } catch (ExecutionException | TimeoutException silent) {
            throw new IOException(program + " said nothing within " + MOST_MINUTES + " minutes");
        } finally {
            window.close();
        }
    }

    /** Opens an empty headless page, driven by a program. */
    Window open() throws IOException, InterruptedException {
        return open("about:blank");
    }

    private Window open(String address) throws IOException, InterruptedException {
        Path profile = Files.createTempDirectory("rigibo-browser");
        Process process =
                new ProcessBuilder(
                                program.toString(),
                                "--headless",
                                "--no-sandbox",
                                "--enable-unsafe-swiftshader",
                                "--use-angle=swiftshader",
                                "--ignore-gpu-blocklist",
                                // Without a graphics card, plain software is faster for all but
                                // WebGL.
                                "--disable-accelerated-2d-canvas",
                                "--disable-gpu-rasterization",
                                "--disable-gpu-compositing",
                                "--no-first-run",
                                "--disable-background-networking",
                                "--disable-component-update",
                                "--disable-sync",
                                "--remote-debugging-port=0",
                                "--user-data-dir=" + profile,
                                address)
                        .redirectErrorStream(true)
                        .redirectOutput(profile.resolve("complaints").toFile())
                        .start();
        return new Window(process, port(process, profile.resolve("DevToolsActivePort")));
    }

    /** The port at which the browser listens; it writes that to a file. */
    private static int port(Process process, Path file) throws IOException, InterruptedException {
        for (int tries = 0; tries < MOST_TRIES && process.isAlive(); tries++) {
            List<String> lines = Files.exists(file) ? Files.readAllLines(file) : List.of();
            if (!lines.isEmpty()) {
                return Integer.parseInt(lines.get(0));
            }
            Thread.sleep(TRY_MILLIS);
        }
        process.destroyForcibly();
        throw new IOException("the browser does not listen");
    }

    /**
     * An open browser.
     *
     * @param port at which it is driven
     */
    record Window(Process process, int port) implements AutoCloseable {

        @Override
        public void close() {
            process.descendants().forEach(ProcessHandle::destroy);
            process.destroy();
        }
    }

    @Override
    public String toString() {
        return program.getFileName().toString();
    }
}

package rigibo.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Firefox on this machine, headless and with a profile of its own. It cannot print a page, so the
 * page itself posts its output.
 */
final class Firefox implements PageReader {

    private static final List<String> NAMES = List.of("firefox", "firefox-esr");

    private static final int MOST_MINUTES = 10;

    /** Most looks for a browser that is starting. */
    private static final int MOST_TRIES = 600;

    private static final int TRY_MILLIS = 100;

    /** The port in the file that Firefox writes when it listens. */
    private static final Pattern PORT = Pattern.compile("\"ws_port\": *(\\d+)");

    /** Settings that prevent requests to other hosts. */
    private static final String SETTINGS =
            """
            user_pref("app.normandy.enabled", false);
            user_pref("app.update.auto", false);
            user_pref("browser.aboutwelcome.enabled", false);
            user_pref("browser.safebrowsing.malware.enabled", false);
            user_pref("browser.safebrowsing.phishing.enabled", false);
            user_pref("browser.shell.checkDefaultBrowser", false);
            user_pref("datareporting.policy.dataSubmissionEnabled", false);
            user_pref("extensions.update.enabled", false);
            user_pref("network.captive-portal-service.enabled", false);
            user_pref("network.connectivity-service.enabled", false);
            user_pref("services.settings.server", "http://localhost/");
            user_pref("toolkit.telemetry.enabled", false);
            user_pref("webgl.force-enabled", true);
            user_pref("webgl.forbid-software", false);
            """;

    private final Path program;

    private Firefox(Path program) {
        this.program = program;
    }

    /** The first Firefox on the path; empty if there is none. */
    static Optional<Firefox> find() {
        return OnPath.first(NAMES).map(Firefox::new);
    }

    @Override
    public String read(LocalServer server, String page) throws IOException, InterruptedException {
        Process process = start(profile(), server.address(page));
        try {
            return server.said().get(MOST_MINUTES, TimeUnit.MINUTES);
        } catch (ExecutionException | TimeoutException silent) {
            throw new IOException(program + " said nothing within " + MOST_MINUTES + " minutes");
        } finally {
            new Browser.Window(process, 0).close();
        }
    }

    /** Opens a window driven by a program. */
    Browser.Window open() throws IOException, InterruptedException {
        Path profile = profile();
        Process process = start(profile, "--remote-debugging-port=0");
        Path told = profile.resolve("WebDriverBiDiServer.json");
        for (int tries = 0; tries < MOST_TRIES && process.isAlive(); tries++) {
            Matcher port = PORT.matcher(Files.exists(told) ? Files.readString(told) : "");
            if (port.find()) {
                return new Browser.Window(process, Integer.parseInt(port.group(1)));
            }
            Thread.sleep(TRY_MILLIS);
        }
        process.destroyForcibly();
        throw new IOException("Firefox does not listen");
    }

    private static Path profile() throws IOException {
        Path folder = Files.createTempDirectory("rigibo-firefox");
        Path profile = Files.createDirectories(folder.resolve("profile"));
        Files.writeString(profile.resolve("user.js"), SETTINGS);
        return profile;
    }

    private Process start(Path profile, String last) throws IOException {
        List<String> words = new ArrayList<>(List.of(program.toString()));
        // Firefox 153 has no WebGL without a display.
        if (System.getenv("DISPLAY") == null) {
            words.add("--headless");
        }
        words.addAll(List.of("--no-remote", "--profile", profile.toString(), last));
        return new ProcessBuilder(words)
                .redirectErrorStream(true)
                .redirectOutput(profile.resolveSibling("complaints").toFile())
                .start();
    }

    @Override
    public String toString() {
        return program.getFileName().toString();
    }
}

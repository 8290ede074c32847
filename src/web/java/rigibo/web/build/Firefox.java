package rigibo.web.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Firefox on this machine, started without a window and with a profile of its own. It prints no
 * page, so that the page itself posts what it has to say.
 */
final class Firefox implements PageReader {

    private static final List<String> NAMES = List.of("firefox", "firefox-esr");

    private static final int MOST_MINUTES = 10;

    /** Nothing is asked of any host but ours. */
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
            """;

    private final Path program;

    private Firefox(Path program) {
        this.program = program;
    }

    /** The first that is on the path, if there is any. */
    static Optional<Firefox> find() {
        return OnPath.first(NAMES).map(Firefox::new);
    }

    @Override
    public String read(LocalServer server, String page) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("rigibo-firefox");
        Path profile = Files.createDirectories(folder.resolve("profile"));
        Files.writeString(profile.resolve("user.js"), SETTINGS);
        Process process =
                new ProcessBuilder(
                                program.toString(),
                                "--headless",
                                "--no-remote",
                                "--profile",
                                profile.toString(),
                                server.address(page))
                        .redirectErrorStream(true)
                        .redirectOutput(folder.resolve("complaints").toFile())
                        .start();
        try {
            return server.said().get(MOST_MINUTES, TimeUnit.MINUTES);
        } catch (ExecutionException | TimeoutException silent) {
            throw new IOException(program + " said nothing within " + MOST_MINUTES + " minutes");
        } finally {
            process.descendants().forEach(ProcessHandle::destroy);
            process.destroy();
        }
    }

    @Override
    public String toString() {
        return program.getFileName().toString();
    }
}

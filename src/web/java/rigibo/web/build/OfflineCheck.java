package rigibo.web.build;

import rigibo.frontend.puzzle.level.Level;

import java.io.IOException;
import java.nio.file.Path;
import java.util.regex.Pattern;

/**
 * Visits the page once and stops its server. The page then opens from the browser's storage, and a
 * level is solved there. At the first visit the browser must find the page installable.
 */
final class OfflineCheck {

    /** Script that waits until the stored files answer for the page. */
    private static final String KEPT =
            "navigator.serviceWorker.ready.then(() => new Promise(done => { const look = () =>"
                    + " navigator.serviceWorker.controller ? done('kept') : setTimeout(look, 20);"
                    + " look(); }))";

    private static final String BY_WORKER =
            "performance.getEntriesByType('navigation')[0].workerStart > 0";

    /** The manifest's members that browsers require for installing a page. */
    private static final Pattern COMPLETE =
            Pattern.compile(
                    "(?s)(?=.*\"name\")(?=.*\"short_name\")(?=.*\"start_url\")(?=.*\"display\":"
                            + " *\"standalone\")(?=.*\"icons\": *\\[ *\\{ *\"src\").*");

    private OfflineCheck() {}

    /**
     * Runs the check and prints the result; returns whether a level was solved without a server.
     */
    static boolean isPlayed(Browser.Window window, Path folder, Path pictures, Level level)
            throws IOException, InterruptedException {
        Phone phone;
        boolean isInstallable;
        try (LocalServer server = new LocalServer(folder, 0)) {
            phone = new Phone(window.port(), server.address(""), pictures);
            phone.open("");
            phone.page().value(KEPT);
            isInstallable = isInstallable(phone.page());
        }
        phone.open(level.id());
        boolean isByWorker = phone.page().value(BY_WORKER).equals("true");
        boolean isSolved = new PhoneCheck(phone).isSolved(level);
        phone.leave();
        phone.complaints().forEach(System.out::println);
        System.out.printf(
                "without a server: installable %s, opened from the browser %s, solved %s%n",
                isInstallable, isByWorker, isSolved);
        return isInstallable && isByWorker && isSolved && phone.complaints().isEmpty();
    }

    private static boolean isInstallable(DevTools page) throws IOException, InterruptedException {
        String manifest =
                page.value("fetch('manifest.webmanifest').then(found => found.text())")
                        .replace("\\\"", "\"");
        String errors = page.send("Page.getInstallabilityErrors", "");
        boolean isComplete = COMPLETE.matcher(manifest).matches();
        boolean isAccepted = errors.contains("\"installabilityErrors\":[]");
        if (!isComplete || !isAccepted) {
            System.out.println("cannot be installed: " + manifest + errors);
        }
        return isComplete && isAccepted;
    }
}

package rigibo.web.build;

import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Pages in a browser as large as a phone. Their clock and their pictures are the check's: each
 * picture makes the steps that the check says, however slow the machine is.
 */
final class Phone {

    static final int WIDTH = 390;
    static final int HEIGHT = 844;

    /** Most steps that the page makes for a picture. */
    static final int AT_ONCE = 4;

    /** Pictures after which the page has told anew what it shows: 0.1 s, at four steps each. */
    private static final int UNTIL_TOLD = 2;

    /** A page that does not begin for so long is broken. */
    private static final int MOST_TRIES = 1200;

    private static final int TRY_MILLIS = 50;

    /** A clock that stands still between pictures, half a step off the steps' own times. */
    private static final String CLOCK =
            "let now = 1000, next = null; performance.now = () => now; window.requestAnimationFrame"
                + " = made => { next = made; return 1; }; window.isReady = () => next !== null;"
                + " window.begin = () => { now += 1000 / 120; made(); }; const made = () => { const"
                + " call = next; next = null; call(now); }; window.go = steps => { while (steps >"
                + " 0) { const some = Math.min(steps, 4); steps -= some; now += some * 1000 / 60;"
                + " made(); } };";

    /** Where the control is whose name begins with a text. */
    private static final String PLACE =
            "[...document.querySelectorAll('#controls > *')].filter(one =>"
                    + " one.getAttribute('aria-label').startsWith('%s')).map(one =>"
                    + " one.getBoundingClientRect()).map(one => (one.left + one.right) / 2 + ' ' +"
                    + " (one.top + one.bottom) / 2)[0] || ''";

    private static final String NAMES =
            "[...document.querySelectorAll('#controls > *')].map(one =>"
                    + " one.getAttribute('aria-label')).join('; ')";

    private final int port;
    private final String address;
    private final Path pictures;
    private final List<String> requests = new ArrayList<>();
    private final List<String> complaints = new ArrayList<>();
    private DevTools page;

    /**
     * A phone that opens pages at an address, and keeps pictures of them in a folder.
     *
     * @param port at which a browser is driven
     */
    Phone(int port, String address, Path pictures) throws IOException, InterruptedException {
        this.port = port;
        this.address = address;
        this.pictures = pictures;
        page = new DevTools(port);
    }

    /** Leaves a page for a new one: after two fingers, Chromium 156 takes touches for clicks. */
    private void turn() throws IOException, InterruptedException {
        leave();
        page = new DevTools(port);
        page.send(
                "Emulation.setDeviceMetricsOverride",
                String.format(
                        "\"width\":%d,\"height\":%d,\"deviceScaleFactor\":1,\"mobile\":true",
                        WIDTH, HEIGHT));
        page.send("Emulation.setTouchEmulationEnabled", "\"enabled\":true");
        page.send(
                "Page.addScriptToEvaluateOnNewDocument",
                "\"source\":\"" + CLOCK.replace("\"", "\\\"") + "\"");
    }

    /** Closes the page that is open. */
    void leave() throws IOException, InterruptedException {
        requests.addAll(page.requests());
        complaints.addAll(page.complaints());
        page.close();
    }

    /** Every address that was asked for by pages that were left. */
    List<String> requests() {
        return requests;
    }

    /** What pages that were left wrote to the console, and their errors. */
    List<String> complaints() {
        return complaints;
    }

    DevTools page() {
        return page;
    }

    /** What the page says in the language that it is in. */
    Words words() throws IOException, InterruptedException {
        return new Words(page.value("document.documentElement.lang"));
    }

    /** Opens the page at a scene, and draws the first picture. */
    void open(String scene) throws IOException, InterruptedException {
        turn();
        show(scene);
    }

    /** Opens it for a player whose system moves little. */
    void openCalmly(String scene) throws IOException, InterruptedException {
        turn();
        page.send(
                "Emulation.setEmulatedMedia",
                "\"features\":[{\"name\":\"prefers-reduced-motion\",\"value\":\"reduce\"}]");
        show(scene);
    }

    private void show(String scene) throws IOException, InterruptedException {
        page.send("Page.navigate", "\"url\":\"" + address + "#" + scene + "\"");
        for (int tries = 0; isLoading(); tries++) {
            if (tries == MOST_TRIES) {
                throw new IOException("the page does not begin: " + page.complaints());
            }
            Thread.sleep(TRY_MILLIS);
        }
        page.value("window.begin()");
    }

    private boolean isLoading() throws IOException, InterruptedException {
        return !page.value("window.isReady && window.isReady() ? 1 : 0").equals("1");
    }

    /**
     * Makes so many steps, and a picture after each {@link #AT_ONCE} of them; the browser itself
     * need not show any but the last one.
     */
    void go(int steps) throws IOException, InterruptedException {
        page.value("window.go(" + steps + ")");
    }

    /** Makes pictures until the page has told what it shows. */
    void goUntilTold() throws IOException, InterruptedException {
        go(UNTIL_TOLD * AT_ONCE);
    }

    /** What screen readers were told. */
    String said() throws IOException, InterruptedException {
        return page.value("document.getElementById('said').textContent");
    }

    /** Whether the page keeps a text of the player's in the browser, under a name with a part. */
    boolean isKept(String part, String text) throws IOException, InterruptedException {
        // It keeps what there is as it is left, without waiting for its next look.
        page.value("dispatchEvent(new Event('pagehide'))");
        String found =
                String.format(
                        "Object.keys(localStorage).filter(name => name.includes('%s') &&"
                                + " localStorage[name].includes('%s')).length",
                        part, text);
        return !page.value(found).equals("0");
    }

    /** Where the control is whose name begins so, px of the page. */
    Spot place(String name) throws IOException, InterruptedException {
        String found = page.value(String.format(PLACE, name));
        if (found.isEmpty()) {
            throw new IOException("there is no " + name + " among " + page.value(NAMES));
        }
        String[] xy = found.split(" ");
        return new Spot(Double.parseDouble(xy[0]), Double.parseDouble(xy[1]));
    }

    /** A point of the page, px. */
    record Spot(double x, double y) {

        Spot plus(double dx, double dy) {
            return new Spot(x + dx, y + dy);
        }
    }

    /** Touches the control whose name begins so. */
    void tap(String name) throws IOException, InterruptedException {
        Spot at = place(name);
        page.down(at);
        page.lift(at);
        goUntilTold();
    }

    /** Drags a finger from one point to another. */
    void drag(Spot from, Spot to) throws IOException, InterruptedException {
        page.down(from);
        page.slide(new Spot((from.x + to.x) / 2, (from.y + to.y) / 2));
        page.lift(to);
        goUntilTold();
    }

    /** A finger stays where it is, and a second one slides away from it or towards it. */
    void pinch(Spot thumb, Spot from, Spot to) throws IOException, InterruptedException {
        page.down(thumb);
        page.down(thumb, from);
        page.slide(thumb, to);
        page.lift(thumb);
    }

    /** Keeps a picture of the page. */
    void picture(String name) throws IOException, InterruptedException {
        Files.write(pictures.resolve(name + ".png"), page.picture());
    }
}

package rigibo.web.build;

import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Pages in a browser of a phone's size, touched by fingers. */
final class Phone {

    static final int WIDTH = 390;
    static final int HEIGHT = 844;

    /** Pictures until the page has described its present state: 0.1 s, at four steps each. */
    private static final int UNTIL_TOLD = 2;

    /** Script for the place of the control whose name begins with a text. */
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
    private Stepped stepped;

    /**
     * A phone that opens pages at an address and stores pictures of them in a folder.
     *
     * @param port at which a browser is driven
     */
    Phone(int port, String address, Path pictures) throws IOException, InterruptedException {
        this.port = port;
        this.address = address;
        this.pictures = pictures;
        page = new DevTools(port);
    }

    /**
     * Opens a new page in place of the old one: after two fingers, Chromium 156 takes touches for
     * clicks.
     */
    private void turn() throws IOException, InterruptedException {
        leave();
        page = new DevTools(port);
        page.phone(WIDTH, HEIGHT);
        stepped = new Stepped(page);
    }

    /** Closes the open page. */
    void leave() throws IOException, InterruptedException {
        requests.addAll(page.requests());
        complaints.addAll(page.complaints());
        page.close();
    }

    /** All addresses that closed pages requested. */
    List<String> requests() {
        return requests;
    }

    /** All output of closed pages to the console, and their errors. */
    List<String> complaints() {
        return complaints;
    }

    DevTools page() {
        return page;
    }

    /** The words of the page's language. */
    Words words() throws IOException, InterruptedException {
        return new Words(page.value("document.documentElement.lang"));
    }

    /** Opens the page at a scene and draws the first picture. */
    void open(String scene) throws IOException, InterruptedException {
        openWith("", scene);
    }

    /** Opens it after a script has changed its environment. */
    void openWith(String script, String scene) throws IOException, InterruptedException {
        turn();
        page.begin(script);
        show(scene);
    }

    /**
     * The sentence that the page shows in place of the game after a script has changed its
     * environment.
     */
    String problemWith(String script, String found) throws IOException, InterruptedException {
        leave();
        page = new DevTools(port);
        page.begin(script);
        page.open(address);
        return page.value(found);
    }

    /** Opens it for a player whose system asks for little motion. */
    void openCalmly(String scene) throws IOException, InterruptedException {
        turn();
        page.send(
                "Emulation.setEmulatedMedia",
                "\"features\":[{\"name\":\"prefers-reduced-motion\",\"value\":\"reduce\"}]");
        show(scene);
    }

    private void show(String scene) throws IOException, InterruptedException {
        stepped.open(address + "#" + scene);
    }

    /** Makes a number of steps. */
    void go(int steps) throws IOException, InterruptedException {
        stepped.go(steps);
    }

    /** Makes pictures until the page has described its present state. */
    void goUntilTold() throws IOException, InterruptedException {
        go(UNTIL_TOLD * Stepped.AT_ONCE);
    }

    /** The page's descriptions and stored files. */
    Stepped stepped() {
        return stepped;
    }

    /** The place of the control whose name begins with a text, px of the page. */
    Page.Spot place(String name) throws IOException, InterruptedException {
        String found = page.value(String.format(PLACE, name));
        if (found.isEmpty()) {
            throw new IOException("there is no " + name + " among " + page.value(NAMES));
        }
        String[] xy = found.split(" ");
        return new Page.Spot(Double.parseDouble(xy[0]), Double.parseDouble(xy[1]));
    }

    /** Touches the control whose name begins with a text. */
    void tap(String name) throws IOException, InterruptedException {
        Page.Spot at = place(name);
        page.down(at);
        page.lift(at);
        goUntilTold();
    }

    /** Drags a finger from one point to another. */
    void drag(Page.Spot from, Page.Spot to) throws IOException, InterruptedException {
        page.down(from);
        page.slide(new Page.Spot((from.x() + to.x()) / 2, (from.y() + to.y()) / 2));
        page.lift(to);
        goUntilTold();
    }

    /** Holds one finger in place and moves a second one away from it or towards it. */
    void pinch(Page.Spot thumb, Page.Spot from, Page.Spot to)
            throws IOException, InterruptedException {
        page.down(thumb);
        page.down(thumb, from);
        page.slide(thumb, to);
        page.lift(thumb);
    }

    /** Stores a picture of the page. */
    void picture(String name) throws IOException, InterruptedException {
        Files.write(pictures.resolve(name + ".png"), page.picture());
    }
}

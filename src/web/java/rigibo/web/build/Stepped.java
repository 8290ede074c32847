package rigibo.web.build;

import java.io.IOException;

/**
 * A page whose clock and pictures are driven by a check: each picture makes the number of steps
 * that the check asks for, however slow the machine is.
 */
final class Stepped {

    /** Most steps that the page makes for a picture. */
    static final int AT_ONCE = 4;

    /** Most looks for a page that is starting; after them it counts as broken. */
    private static final int MOST_TRIES = 400;

    private static final int TRY_MILLIS = 50;

    /** Script of a clock that stands still between pictures, half a step off the times of steps. */
    private static final String CLOCK =
            "let now = 1000, next = null; performance.now = () => now; window.requestAnimationFrame"
                + " = made => { next = made; return 1; }; window.isReady = () => next !== null;"
                + " window.begin = () => { now += 1000 / 120; made(); }; const made = () => { const"
                + " call = next; next = null; call(now); }; window.go = steps => { while (steps >"
                + " 0) { const some = Math.min(steps, 4); steps -= some; now += some * 1000 / 60;"
                + " made(); } };";

    private final Page page;

    /** Replaces the clock of all documents that a page opens later. */
    Stepped(Page page) throws IOException, InterruptedException {
        this.page = page;
        page.begin(CLOCK);
    }

    /** Opens an address and draws the first picture. */
    void open(String address) throws IOException, InterruptedException {
        page.open(address);
        for (int tries = 0; isLoading(); tries++) {
            if (tries == MOST_TRIES) {
                throw new IOException("the page does not begin: " + problem() + page.complaints());
            }
            Thread.sleep(TRY_MILLIS);
        }
        page.value("window.begin()");
    }

    /** The sentence that the page shows in place of the game. */
    String problem() throws IOException, InterruptedException {
        return page.value("document.getElementById('problem').textContent");
    }

    private boolean isLoading() throws IOException, InterruptedException {
        return !page.value("window.isReady && window.isReady() ? 1 : 0").equals("1");
    }

    /**
     * Makes a number of steps, with a picture after each {@link #AT_ONCE} of them; the browser may
     * show only the last one.
     */
    void go(int steps) throws IOException, InterruptedException {
        page.value("window.go(" + steps + ")");
    }

    /** The texts for screen readers. */
    String said() throws IOException, InterruptedException {
        return page.value("document.getElementById('said').textContent");
    }

    /**
     * Whether the page has stored a text of the player's in the browser, under a name with a part.
     */
    boolean isKept(String part, String text) throws IOException, InterruptedException {
        keep();
        String found =
                String.format(
                        "Object.keys(localStorage).filter(name => name.includes('%s') &&"
                                + " localStorage[name].includes('%s')).length",
                        part, text);
        return !page.value(found).equals("0");
    }

    /** Makes the page store its files as when it is left, without waiting for its next look. */
    void keep() throws IOException, InterruptedException {
        page.value("dispatchEvent(new Event('pagehide'))");
    }
}

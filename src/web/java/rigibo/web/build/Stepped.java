package rigibo.web.build;

import java.io.IOException;

/**
 * A page whose clock and pictures are a check's: each picture makes the steps that the check says,
 * however slow the machine is.
 */
final class Stepped {

    /** Most steps that the page makes for a picture. */
    static final int AT_ONCE = 4;

    /** A page that does not begin for so long is broken. */
    private static final int MOST_TRIES = 400;

    private static final int TRY_MILLIS = 50;

    /** A clock that stands still between pictures, half a step off the steps' own times. */
    private static final String CLOCK =
            "let now = 1000, next = null; performance.now = () => now; window.requestAnimationFrame"
                + " = made => { next = made; return 1; }; window.isReady = () => next !== null;"
                + " window.begin = () => { now += 1000 / 120; made(); }; const made = () => { const"
                + " call = next; next = null; call(now); }; window.go = steps => { while (steps >"
                + " 0) { const some = Math.min(steps, 4); steps -= some; now += some * 1000 / 60;"
                + " made(); } };";

    private final Page page;

    /** Takes the clock of all that a page opens from now on. */
    Stepped(Page page) throws IOException, InterruptedException {
        this.page = page;
        page.begin(CLOCK);
    }

    /** Opens an address, and draws the first picture. */
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

    /** What the page says in place of the game. */
    String problem() throws IOException, InterruptedException {
        return page.value("document.getElementById('problem').textContent");
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

    /** What screen readers were told. */
    String said() throws IOException, InterruptedException {
        return page.value("document.getElementById('said').textContent");
    }

    /** Whether the page keeps a text of the player's in the browser, under a name with a part. */
    boolean isKept(String part, String text) throws IOException, InterruptedException {
        keep();
        String found =
                String.format(
                        "Object.keys(localStorage).filter(name => name.includes('%s') &&"
                                + " localStorage[name].includes('%s')).length",
                        part, text);
        return !page.value(found).equals("0");
    }

    /** The page keeps what there is as when it is left, without waiting for its next look. */
    void keep() throws IOException, InterruptedException {
        page.value("dispatchEvent(new Event('pagehide'))");
    }
}

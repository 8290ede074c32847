package rigibo.frontend.save;

import org.teavm.jso.browser.Window;

/** Does work a little later, between two pictures. */
final class Writer {

    private boolean isClosed;

    void in(long millis, Runnable work) {
        if (!isClosed) {
            Window.setTimeout(work::run, (int) millis);
        }
    }

    boolean isClosed() {
        return isClosed;
    }

    void close() {
        isClosed = true;
    }
}

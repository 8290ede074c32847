package rigibo.frontend.scene.trial;

import org.teavm.jso.browser.Window;

import java.util.concurrent.Executor;

/** Does work between two pictures, for the page has no other thread. */
final class Background implements Executor {

    private boolean isClosed;

    @Override
    public void execute(Runnable work) {
        Window.setTimeout(() -> run(work), 0);
    }

    private void run(Runnable work) {
        if (!isClosed) {
            work.run();
        }
    }

    void close() {
        isClosed = true;
    }
}

package rigibo.frontend.scene.trial;

import org.teavm.jso.browser.Window;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.BooleanSupplier;

/** Does trials between two pictures, a piece at a time, for the page has no other thread. */
final class Background {

    /** Rest after a piece, in its own lengths: pictures come first. */
    private static final double REST = 8;

    private static final double MILLISECOND = 1e6;

    private final Queue<BooleanSupplier> trials = new ArrayDeque<>();
    private boolean isClosed;

    /** Does all pieces of a trial, after those of the trials before. */
    void take(BooleanSupplier pieces) {
        trials.add(pieces);
        if (trials.size() == 1) {
            goOnAfter(0);
        }
    }

    private void goOnAfter(double millis) {
        Window.setTimeout(this::goOn, millis);
    }

    private void goOn() {
        if (isClosed) {
            return;
        }
        long begin = System.nanoTime();
        if (!trials.element().getAsBoolean()) {
            trials.remove();
        }
        if (!trials.isEmpty()) {
            goOnAfter(REST * (System.nanoTime() - begin) / MILLISECOND);
        }
    }

    void close() {
        isClosed = true;
    }
}

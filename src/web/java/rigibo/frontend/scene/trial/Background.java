package rigibo.frontend.scene.trial;

import org.teavm.jso.browser.Window;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.BooleanSupplier;

/** Runs trials between two pictures, piece by piece, since the page has no other thread. */
final class Background {

    /** Time of a picture, ns. */
    private static final long PICTURE = 16_000_000;

    /** Pause after a piece, in multiples of its duration: pictures have precedence. */
    private static final double REST = 8;

    private static final double MILLISECOND = 1e6;

    private final Queue<BooleanSupplier> trials = new ArrayDeque<>();
    private boolean isClosed;

    /** Runs all pieces of a trial, after those of earlier trials. */
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

    /** A picture. */
    static long unseen() {
        return PICTURE;
    }

    /** What a picture with four steps makes up for. */
    static long mostPiece() {
        return 4 * PICTURE;
    }

    void close() {
        isClosed = true;
    }
}

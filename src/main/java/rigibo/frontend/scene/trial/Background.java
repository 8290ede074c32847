package rigibo.frontend.scene.trial;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.BooleanSupplier;

/** A thread beside the loop, which begins with the first work that it is given. */
final class Background {

    private final ExecutorService thread = Executors.newSingleThreadExecutor(Background::thread);

    private static Thread thread(Runnable trials) {
        Thread thread = new Thread(trials, "trials");
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        return thread;
    }

    /** Does all pieces of a trial, after those of the trials before. */
    void take(BooleanSupplier pieces) {
        thread.execute(() -> Trials.all(pieces));
    }

    /** No piece of another thread makes a picture late. */
    static long unseen() {
        return Long.MAX_VALUE;
    }

    static long mostPiece() {
        return Long.MAX_VALUE;
    }

    /** Ends the thread, whatever it does. */
    void close() {
        thread.shutdownNow();
    }
}

package rigibo.frontend.save;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** Does work a little later, on a thread of its own, so that no frame waits for a disk. */
final class Writer {

    private final ScheduledExecutorService thread =
            Executors.newSingleThreadScheduledExecutor(
                    work -> {
                        Thread writing = new Thread(work, "saving");
                        writing.setDaemon(true);
                        return writing;
                    });

    /** Does work in some ms, unless it was closed. */
    void in(long millis, Runnable work) {
        if (!isClosed()) {
            thread.schedule(work, millis, TimeUnit.MILLISECONDS);
        }
    }

    boolean isClosed() {
        return thread.isShutdown();
    }

    void close() {
        thread.shutdown();
    }
}

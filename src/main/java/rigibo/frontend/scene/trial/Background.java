package rigibo.frontend.scene.trial;

import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** A thread beside the loop, which begins with the first work that it is given. */
final class Background implements Executor {

    private final ExecutorService thread = Executors.newSingleThreadExecutor(Background::thread);

    private static Thread thread(Runnable trials) {
        Thread thread = new Thread(trials, "trials");
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        return thread;
    }

    @Override
    public void execute(Runnable work) {
        thread.execute(work);
    }

    /** Ends the thread, whatever it does. */
    void close() {
        thread.shutdownNow();
    }
}

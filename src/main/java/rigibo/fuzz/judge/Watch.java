package rigibo.fuzz.judge;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Optional;

/**
 * What a thread does and since when, for another thread to read. Times are processor times, which
 * other programs do not influence.
 */
public final class Watch {

    private static final double NANOS = 1e-9;

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();

    /** A task of a thread, with the thread's processor time at its start. */
    private record Begun(String what, long thread, long nanos) {}

    private volatile Begun present = new Begun("nothing", Thread.currentThread().getId(), 0);

    /** Reports that the calling thread begins a task. */
    public void begins(String what) {
        long nanos = threads.getCurrentThreadCpuTime();
        present = new Begun(what, Thread.currentThread().getId(), nanos);
    }

    /** The tasks that have taken longer than a time in s; ended threads are ignored. */
    public Optional<String> overdue(double seconds) {
        Begun now = present;
        double taken = NANOS * (threads.getThreadCpuTime(now.thread()) - now.nanos());
        return taken > seconds ? Optional.of(now.what()) : Optional.empty();
    }
}

package rigibo.lab.child;

/** Stands in for measurements of a thread; a page knows the time only. */
public final class ThreadUse {

    private ThreadUse() {}

    /** Wall-clock time, ns. */
    public static long nanos() {
        return System.nanoTime();
    }

    /** Returns 0, since browsers do not report allocations. */
    public static long bytes() {
        return 0;
    }
}

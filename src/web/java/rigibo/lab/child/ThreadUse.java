package rigibo.lab.child;

/** What is known in a page of the thread that asks: the time. */
public final class ThreadUse {

    private ThreadUse() {}

    /** Time of the wall, ns. */
    public static long nanos() {
        return System.nanoTime();
    }

    /** Browsers do not tell. */
    public static long bytes() {
        return 0;
    }
}

package rigibo.lab.child;

import java.util.function.Consumer;

/** Reports from time to time how many runs are done and how long the others will take. */
public final class Progress {

    private static final long NANOS_BETWEEN_WORDS = 15_000_000_000L;
    private static final double NANOS_PER_MINUTE = 60e9;

    private final int count;
    private final Consumer<String> tell;
    private final long begun = System.nanoTime();
    private long told = begun;
    private int done;

    public Progress(int count, Consumer<String> tell) {
        this.count = count;
        this.tell = tell;
        tell.accept(count + " runs to make");
    }

    public void done() {
        done++;
        long now = System.nanoTime();
        if (now - told > NANOS_BETWEEN_WORDS || done == count) {
            told = now;
            double minutes = (now - begun) / NANOS_PER_MINUTE * (count - done) / done;
            tell.accept(done + " of " + count + " done, " + left(minutes) + " left");
        }
    }

    private static String left(double minutes) {
        return minutes < 1 ? "less than a minute" : Math.round(minutes) + " min";
    }
}

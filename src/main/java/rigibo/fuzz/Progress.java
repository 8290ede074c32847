package rigibo.fuzz;

import rigibo.fuzz.judge.Tally;

import java.util.function.Consumer;

/** Reports progress from time to time. */
final class Progress {

    private static final long EVERY_NANOS = 10_000_000_000L;

    private final Consumer<String> out;
    private final Tally tally;
    private long last = System.nanoTime();

    Progress(Consumer<String> out, Tally tally) {
        this.out = out;
        this.tally = tally;
    }

    void tell() {
        if (System.nanoTime() - last > EVERY_NANOS) {
            last = System.nanoTime();
            out.accept(tally.toString());
        }
    }
}

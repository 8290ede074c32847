package rigibo.web.library;

/** A sum. */
public final class LongAdder {

    private long sum;

    public void increment() {
        sum++;
    }

    public void add(long more) {
        sum += more;
    }

    public long sum() {
        return sum;
    }
}

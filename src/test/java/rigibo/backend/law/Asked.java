package rigibo.backend.law;

import java.util.Optional;

/** How often a law was put to the test, and how near it came to its limit. */
final class Asked {

    private long times;
    private double nearest;

    /** Takes note of more occasions on which the law could have been broken. */
    void more(long occasions) {
        times += occasions;
    }

    long times() {
        return times;
    }

    /** The largest figure as a share of its limit; 0 where the limit is 0 and was kept. */
    double nearest() {
        return nearest;
    }

    /** A complaint where a figure is above its limit or NaN; nothing where it keeps it. */
    Optional<String> atMost(double limit, double figure, String words) {
        if (figure <= limit) {
            nearest = Math.max(nearest, limit == 0 ? 0 : figure / limit);
            return Optional.empty();
        }
        return Optional.of(words + " " + figure + ", at most " + limit);
    }
}

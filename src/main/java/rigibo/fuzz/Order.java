package rigibo.fuzz;

import java.util.concurrent.TimeUnit;

/**
 * What to try, and for how long.
 *
 * @param seed of everything: the same seed tries the same
 * @param first index of those of the seed that is tried
 * @param programs how many at most
 * @param files how many at most
 * @param failures after how many it is enough
 * @param end of {@code System.nanoTime}, when it is enough
 */
public record Order(long seed, long first, long programs, long files, long failures, long end) {

    private static final double SECONDS_PER_MINUTE = 60;

    /** An order for a number of minutes that ends at the first failure. */
    public static Order minutes(double minutes, long seed, long first) {
        long span = (long) (minutes * SECONDS_PER_MINUTE * TimeUnit.SECONDS.toNanos(1));
        return new Order(seed, first, Long.MAX_VALUE, Long.MAX_VALUE, 1, System.nanoTime() + span);
    }

    /** An order for a number of programs and files that ends at the first failure. */
    public static Order counted(long programs, long files, long seed, long first) {
        long never = System.nanoTime() + Long.MAX_VALUE;
        return new Order(seed, first, programs, files, 1, never);
    }

    /** A copy that ends after a number of failures. */
    public Order failures(long most) {
        return new Order(seed, first, programs, files, most, end);
    }

    boolean goesOn(long round) {
        return round < Math.max(programs, files) && System.nanoTime() - end < 0;
    }

    long most(String subject) {
        return subject.equals("files") ? files : programs;
    }
}

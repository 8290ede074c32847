package rigibo.fuzz;

import java.util.concurrent.TimeUnit;

/**
 * What to try, and for how long.
 *
 * @param seed of all random numbers: equal seeds try the same
 * @param first index of the first program or file that is tried
 * @param programs number of programs at most
 * @param files number of files at most
 * @param failures number of failures after which to stop
 * @param end {@code System.nanoTime} at which to stop
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

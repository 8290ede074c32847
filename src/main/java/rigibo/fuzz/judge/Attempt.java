package rigibo.fuzz.judge;

import static rigibo.fuzz.judge.LawBroken.unless;

import com.sun.management.ThreadMXBean;

import rigibo.fuzz.program.Operation;
import rigibo.fuzz.program.Stage;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.management.ManagementFactory;

/** Runs operations and distinguishes refusals from defects. */
public final class Attempt {

    /** The most that one call may allocate, B: some thousand times what these pools need. */
    private static final long MOST_ALLOCATED = 256 << 20;

    /** The length of the shortest sentence that names a field, a value and a range. */
    private static final int LEAST_WORDS = 15;

    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    Attempt() {}

    /** Runs an operation; returns the words of its refusal, empty if it was done. */
    String make(Operation operation, Stage stage) {
        long before = allocated();
        try {
            operation.act().accept(stage);
            return "";
        } catch (LawBroken broken) {
            throw broken;
        } catch (IllegalArgumentException | IllegalStateException refusal) {
            return words(operation, refusal);
        } catch (RuntimeException | Error thrown) {
            throw new LawBroken("nothing is thrown but refusals", trace(thrown), thrown);
        } finally {
            long taken = allocated() - before;
            unless(
                    taken <= MOST_ALLOCATED,
                    "no call takes memory beyond bounds",
                    "%s allocated %d B",
                    operation.java(),
                    taken);
        }
    }

    private long allocated() {
        return threads.getThreadAllocatedBytes(Thread.currentThread().getId());
    }

    private static String words(Operation operation, RuntimeException refusal) {
        String words = refusal.getMessage();
        unless(
                words != null && words.length() >= LEAST_WORDS,
                "a refusal says why",
                "%s: %s",
                operation.java(),
                trace(refusal));
        return words;
    }

    /** An exception with its stack, as text. */
    public static String trace(Throwable thrown) {
        StringWriter words = new StringWriter();
        thrown.printStackTrace(new PrintWriter(words));
        return words.toString();
    }
}

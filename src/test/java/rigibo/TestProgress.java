package rigibo;

import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.TestSource;
import org.junit.platform.engine.support.descriptor.ClassSource;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;

/**
 * Prints one line for each test class while the tests run, and at their end writes {@code passed
 * failed} to the file that the property {@code rigibo.test.counts} names, for the start script.
 * Several classes may run at a time.
 */
public final class TestProgress implements TestExecutionListener {

    private static final class Score {
        private final long start = System.nanoTime();
        private int passed;
        private int failed;
    }

    /** Taken at the start, since tests may put another in its place. */
    private final PrintStream out = System.out;

    private final Score all = new Score();

    /** By the names of top-level classes, from each one's start. */
    private final Map<String, Score> classes = new HashMap<>();

    @Override
    public synchronized void executionStarted(TestIdentifier identifier) {
        scoreOf(identifier);
    }

    @Override
    public synchronized void executionFinished(
            TestIdentifier identifier, TestExecutionResult result) {
        Score score = scoreOf(identifier);
        switch (result.getStatus()) {
            case SUCCESSFUL -> {
                score.passed += identifier.isTest() ? 1 : 0;
                all.passed += identifier.isTest() ? 1 : 0;
            }
            // A class that fails by itself, in its set-up say, counts as one failure too.
            case FAILED -> {
                score.failed++;
                all.failed++;
                out.println("  FAILED " + nameOf(identifier));
            }
            case ABORTED -> {
                String reason = result.getThrowable().map(Throwable::getMessage).orElse("");
                executionSkipped(identifier, reason);
            }
        }
        if (isTopLevelClass(identifier)) {
            print(identifier, score);
        }
    }

    @Override
    public void executionSkipped(TestIdentifier identifier, String reason) {
        out.println("  passed over " + nameOf(identifier) + ": " + reason);
    }

    private void print(TestIdentifier identifier, Score score) {
        out.printf(
                "  %-60s %4d passed%s %6.1f s%n",
                identifier.getLegacyReportingName(),
                score.passed,
                score.failed == 0 ? "" : ", " + score.failed + " failed,",
                (System.nanoTime() - score.start) * 1e-9);
    }

    @Override
    public void testPlanExecutionFinished(TestPlan plan) {
        String file = System.getProperty("rigibo.test.counts");
        if (file == null) {
            return;
        }
        try {
            Files.writeString(Path.of(file), all.passed + " " + all.failed + "\n");
        } catch (IOException cause) {
            throw new UncheckedIOException(cause);
        }
    }

    private Score scoreOf(TestIdentifier identifier) {
        String name = classOf(identifier);
        int nested = name.indexOf('$');
        String topLevel = nested < 0 ? name : name.substring(0, nested);
        return classes.computeIfAbsent(topLevel, key -> new Score());
    }

    private static boolean isTopLevelClass(TestIdentifier identifier) {
        return identifier.getSource().filter(ClassSource.class::isInstance).isPresent()
                && classOf(identifier).indexOf('$') < 0;
    }

    /** Empty for what is in no class, as the engine that runs the tests. */
    private static String classOf(TestIdentifier identifier) {
        TestSource source = identifier.getSource().orElse(null);
        if (source instanceof MethodSource method) {
            return method.getClassName();
        }
        return source instanceof ClassSource test ? test.getClassName() : "";
    }

    private static String nameOf(TestIdentifier identifier) {
        String name = identifier.getLegacyReportingName();
        return identifier.getSource().orElse(null) instanceof MethodSource method
                ? method.getClassName() + ": " + name
                : name;
    }
}

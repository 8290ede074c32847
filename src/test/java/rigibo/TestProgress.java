package rigibo;

import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.support.descriptor.ClassSource;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Prints one line for each test class while the tests run, and at their end writes {@code passed
 * failed} to the file that the property {@code rigibo.test.counts} names, for the start script.
 */
public final class TestProgress implements TestExecutionListener {
    private int passed;
    private int failed;
    private int passedBefore;
    private int failedBefore;
    private long classStart;

    @Override
    public void executionStarted(TestIdentifier identifier) {
        if (isTopLevelClass(identifier)) {
            passedBefore = passed;
            failedBefore = failed;
            classStart = System.nanoTime();
        }
    }

    @Override
    public void executionFinished(TestIdentifier identifier, TestExecutionResult result) {
        count(identifier, result);
        if (isTopLevelClass(identifier)) {
            printClass(identifier);
        }
    }

    /** A class that fails by itself, in its set-up say, counts as one failure too. */
    private void count(TestIdentifier identifier, TestExecutionResult result) {
        switch (result.getStatus()) {
            case SUCCESSFUL -> passed += identifier.isTest() ? 1 : 0;
            case FAILED -> {
                failed++;
                System.out.println("  FAILED " + nameOf(identifier));
            }
            case ABORTED -> {
                String reason = result.getThrowable().map(Throwable::getMessage).orElse("");
                executionSkipped(identifier, reason);
            }
        }
    }

    @Override
    public void executionSkipped(TestIdentifier identifier, String reason) {
        System.out.println("  passed over " + nameOf(identifier) + ": " + reason);
    }

    private void printClass(TestIdentifier identifier) {
        int failures = failed - failedBefore;
        System.out.printf(
                "  %-60s %4d passed%s %6.1f s%n",
                identifier.getLegacyReportingName(),
                passed - passedBefore,
                failures == 0 ? "" : ", " + failures + " failed,",
                (System.nanoTime() - classStart) * 1e-9);
    }

    @Override
    public void testPlanExecutionFinished(TestPlan plan) {
        String file = System.getProperty("rigibo.test.counts");
        if (file == null) {
            return;
        }
        try {
            Files.writeString(Path.of(file), passed + " " + failed + "\n");
        } catch (IOException cause) {
            throw new UncheckedIOException(cause);
        }
    }

    private static String nameOf(TestIdentifier identifier) {
        String name = identifier.getLegacyReportingName();
        return identifier
                .getSource()
                .filter(MethodSource.class::isInstance)
                .map(source -> ((MethodSource) source).getClassName() + ": " + name)
                .orElse(name);
    }

    private static boolean isTopLevelClass(TestIdentifier identifier) {
        return identifier
                .getSource()
                .filter(ClassSource.class::isInstance)
                .map(source -> ((ClassSource) source).getClassName())
                .filter(name -> name.indexOf('$') < 0)
                .isPresent();
    }
}

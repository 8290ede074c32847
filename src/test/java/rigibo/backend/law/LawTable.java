package rigibo.backend.law;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;

/**
 * Appends a line of Markdown for every law that was asked to the file that the property {@code
 * rigibo.laws} names: the table of docs/laws.md.
 */
final class LawTable {

    private static final String FILE = System.getProperty("rigibo.laws");

    private LawTable() {}

    static boolean isWanted() {
        return FILE != null;
    }

    static void note(Seeds seeds, Preset preset, Asked asked, Quota quota) {
        if (!isWanted()) {
            return;
        }
        String line =
                String.format(
                        Locale.ROOT,
                        "| %s | %s | %d | %,d %s | %,d | %.2g |%n",
                        test(),
                        preset,
                        seeds.asked().size(),
                        asked.times(),
                        quota.what(),
                        quota.least(),
                        asked.nearest());
        try {
            Files.writeString(
                    Path.of(FILE), line, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        } catch (IOException cause) {
            throw new UncheckedIOException(cause);
        }
    }

    /** The test that holds the law: others may wait further down the same thread's stack. */
    private static String test() {
        return StackWalker.getInstance()
                .walk(
                        frames ->
                                frames.dropWhile(frame -> !isTest(frame))
                                        .takeWhile(LawTable::isTest)
                                        .reduce((inner, outer) -> outer))
                .map(StackWalker.StackFrame::getMethodName)
                .orElseThrow();
    }

    private static boolean isTest(StackWalker.StackFrame frame) {
        return frame.getClassName().endsWith("Test");
    }
}

package rigibo.lab.precision;

import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Finding;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * What was found, in a file that grows by a line each, so that an interrupted report goes on where
 * it was. What was found by other classes, or more hastily, stays in it and does not count.
 */
final class PointLog {

    private static final String BETWEEN_FIELDS = "\t";

    /** Key, problem, engine, setting, patience. */
    private static final int OWN_FIELDS = 5;

    private final Path file;
    private final String key;
    private final Map<String, Finding> findings = new HashMap<>();

    /**
     * Reads what is there.
     *
     * @param key of what counts
     */
    PointLog(Path file, String key) {
        this.file = file;
        this.key = key;
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            if (!Files.exists(file)) {
                Files.createFile(file);
            }
            String text = Files.readString(file);
            // A line that was being written when the machine stopped is made again.
            String whole = text.substring(0, text.lastIndexOf('\n') + 1);
            Files.writeString(file, whole);
            whole.lines().filter(line -> line.startsWith(key + BETWEEN_FIELDS)).forEach(this::take);
        } catch (IOException cause) {
            throw new UncheckedIOException("cannot read " + file, cause);
        }
    }

    private void take(String line) {
        String[] field = line.split(BETWEEN_FIELDS, OWN_FIELDS + 1);
        String name = String.join(BETWEEN_FIELDS, java.util.Arrays.copyOf(field, OWN_FIELDS));
        findings.put(name, Finding.parse(field[OWN_FIELDS]));
    }

    /** What was found at a setting of a task, if it was run. */
    Optional<Finding> of(Task task, Setting setting) {
        return Optional.ofNullable(findings.get(name(task, setting)));
    }

    /** Keeps what was found. */
    void add(Task task, Setting setting, Finding finding) {
        String name = name(task, setting);
        findings.put(name, finding);
        try {
            Files.writeString(
                    file, name + BETWEEN_FIELDS + finding.line() + "\n", StandardOpenOption.APPEND);
        } catch (IOException cause) {
            throw new UncheckedIOException("cannot write " + file, cause);
        }
    }

    private String name(Task task, Setting setting) {
        return String.join(
                BETWEEN_FIELDS,
                key,
                task.problem(),
                task.engine(),
                setting.name(),
                task.patience().words());
    }
}

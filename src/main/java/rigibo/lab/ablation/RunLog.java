package rigibo.lab.ablation;

import rigibo.lab.ablation.probe.Sample;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The runs that were made, in a file that grows by a line each, so that an interrupted table goes
 * on where it was. Runs of other classes, another seed or another Java stay in it and do not count.
 */
final class RunLog {

    private static final String HEAD =
            "key,workload,engine,round,budget," + String.join(",", Sample.FIELDS);

    /** Fields before those of the sample. */
    private static final int OWN_FIELDS = 5;

    private final Path file;
    private final String key;
    private final Map<String, Sample> samples = new TreeMap<>();

    /**
     * Reads what is there.
     *
     * @param key of the runs that count
     */
    RunLog(Path file, String key) {
        this.file = file;
        this.key = key;
        try {
            if (!Files.exists(file)) {
                Files.writeString(file, HEAD + "\n");
            }
            String text = Files.readString(file);
            // A line that was being written when the machine stopped is made again.
            String whole = text.substring(0, text.lastIndexOf('\n') + 1);
            if (whole.length() < text.length()) {
                Files.writeString(file, whole);
            }
            whole.lines().skip(1).forEach(this::take);
        } catch (IOException cause) {
            throw new UncheckedIOException("cannot read " + file, cause);
        }
    }

    private void take(String line) {
        List<String> fields = List.of(line.split(",", OWN_FIELDS + 1));
        if (fields.size() > OWN_FIELDS && fields.get(0).equals(key)) {
            String name = String.join(",", fields.subList(0, OWN_FIELDS));
            samples.put(name, Sample.parse(fields.get(OWN_FIELDS)));
        }
    }

    /** Whether a run was made. */
    boolean has(Run run) {
        return samples.containsKey(name(run));
    }

    /**
     * What a run found.
     *
     * @throws IllegalStateException when it was not made
     */
    Sample of(Run run) {
        if (!has(run)) {
            throw new IllegalStateException("not run: " + run);
        }
        return samples.get(name(run));
    }

    /** Keeps what a run found. */
    void add(Run run, Sample sample) {
        samples.put(name(run), sample);
        try {
            Files.writeString(
                    file, name(run) + "," + sample.line() + "\n", StandardOpenOption.APPEND);
        } catch (IOException cause) {
            throw new UncheckedIOException("cannot write " + file, cause);
        }
    }

    private String name(Run run) {
        return String.join(
                ",", key, run.workload(), run.engine().name(), "" + run.round(), "" + run.budget());
    }
}

package rigibo.lab.child;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * A log of results, one line each, from which an interrupted report continues. Results under
 * another key, for instance of other classes, stay in the file and are ignored.
 */
public final class Kept {

    private static final String BETWEEN_FIELDS = "\t";
    private static final int FIELDS = 3;

    private final Path file;
    private final String key;
    private final Map<String, String> found = new HashMap<>();

    /**
     * Reads the results in a file.
     *
     * @param file made where there is none, with its directories
     * @param key of what counts
     */
    public Kept(Path file, String key) {
        this.file = file;
        this.key = key;
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            if (!Files.exists(file)) {
                Files.createFile(file);
            }
            String text = Files.readString(file);
            // An incomplete last line, left by an interruption, is dropped.
            String whole = text.substring(0, text.lastIndexOf('\n') + 1);
            Files.writeString(file, whole);
            whole.lines().forEach(this::take);
        } catch (IOException cause) {
            throw new UncheckedIOException("cannot read " + file, cause);
        }
    }

    private void take(String line) {
        String[] field = line.split(BETWEEN_FIELDS, FIELDS);
        if (field.length == FIELDS && field[0].equals(key)) {
            found.put(field[1], field[2]);
        }
    }

    /** The result under a name. */
    public Optional<String> of(String name) {
        return Optional.ofNullable(found.get(name));
    }

    /** Appends a result of one line under a name without tabs. */
    public void add(String name, String line) {
        found.put(name, line);
        try {
            Files.writeString(
                    file,
                    String.join(BETWEEN_FIELDS, key, name, line) + "\n",
                    StandardOpenOption.APPEND);
        } catch (IOException cause) {
            throw new UncheckedIOException("cannot write " + file, cause);
        }
    }

    /**
     * Makes the missing runs, one after the other.
     *
     * @param name under which the result of a run is kept
     * @param result makes a run
     * @param tell is told how far it is
     */
    public <R> void make(
            List<R> runs,
            Function<R, String> name,
            Function<R, String> result,
            Consumer<String> tell) {
        List<R> missing = runs.stream().filter(run -> of(name.apply(run)).isEmpty()).toList();
        Progress progress = new Progress(missing.size(), tell);
        for (R run : missing) {
            add(name.apply(run), result.apply(run));
            progress.done();
        }
    }
}

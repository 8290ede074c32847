package rigibo.fuzz.file;

import com.sun.management.ThreadMXBean;

import rigibo.fuzz.chance.Chance;
import rigibo.fuzz.judge.Attempt;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Lets the game read mutated files and checks that no exception escapes, a refusal is a sentence,
 * memory is bounded, and no data of the player is lost.
 */
public final class FileJudge {

    /** The memory in B that may be used beyond that for an unchanged file. */
    private static final long MOST_ALLOCATED = 64 << 20;

    /** The share of files that are not mutated, which must still be readable. */
    private static final double WHOLE = 0.05;

    /** The length of the shortest sentence. */
    private static final int LEAST_WORDS = 10;

    /** A file to read. */
    private record Case(Reader reader, Sample sample, boolean isWhole) {}

    private record Kind(Reader reader, List<Sample> samples, long allocated) {}

    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final List<Kind> kinds = new ArrayList<>();
    private boolean isRefused;

    /** A judge of all kinds of files that the game reads. */
    public FileJudge() {
        List<Reader> readers =
                List.of(
                        new PlayerReader("settings"),
                        new PlayerReader("progress"),
                        new LevelReader(),
                        new ReplayReader(),
                        new DraftReader(),
                        new UnsavedReader());
        readers.forEach(reader -> kinds.add(kind(reader)));
    }

    private Kind kind(Reader reader) {
        List<Sample> samples = inFolder(reader::samples);
        // The first reading loads classes and schemas, and does not count.
        taken(new Case(reader, samples.get(0), true));
        return new Kind(reader, samples, taken(new Case(reader, samples.get(0), true)));
    }

    private long taken(Case whole) {
        long before = allocated();
        Optional<String> wrong = judge(whole);
        if (wrong.isPresent()) {
            throw new IllegalStateException(whole.reader().title() + ": " + wrong.get());
        }
        return allocated() - before;
    }

    /** Tries the file with an index among those of a seed; returns the failure, if any. */
    public Optional<FileFailure> judge(long seed, long index) {
        Chance chance = Chance.of(seed, ~index);
        Kind kind = chance.oneOf(kinds);
        Sample sample = chance.oneOf(kind.samples());
        boolean isWhole = chance.happens(WHOLE);
        byte[] bytes = isWhole ? sample.bytes() : new Mutation(chance).of(sample.bytes());
        Case mutated = new Case(kind.reader(), new Sample(sample.name(), bytes), isWhole);
        long before = allocated();
        Optional<String> wrong = judge(mutated);
        long taken = allocated() - before - kind.allocated();
        if (wrong.isEmpty() && taken > MOST_ALLOCATED) {
            wrong = Optional.of("took " + taken + " B for " + bytes.length + " B of file");
        }
        return wrong.map(words -> new FileFailure(kind.reader().title(), mutated.sample(), words));
    }

    /** Whether the last file was refused. */
    public boolean isRefused() {
        return isRefused;
    }

    private Optional<String> judge(Case read) {
        return inFolder(folder -> judge(read, folder));
    }

    private Optional<String> judge(Case read, Path folder) throws IOException {
        Path file = folder.resolve(read.sample().name());
        Files.write(file, read.sample().bytes());
        isRefused = false;
        try {
            String complaint = read.reader().read(file);
            isRefused = !complaint.isEmpty();
            return wrongWith(read, complaint, folder);
        } catch (Reader.Refused refused) {
            isRefused = true;
            String words = refused.getMessage();
            return wrongWith(read, words == null ? "null" : words, folder);
        } catch (RuntimeException | Error thrown) {
            return Optional.of(Attempt.trace(thrown));
        }
    }

    private Optional<String> wrongWith(Case read, String complaint, Path folder)
            throws IOException {
        if (read.isWhole() && isRefused) {
            return Optional.of("a whole file is refused: " + complaint);
        }
        if (isRefused && complaint.length() < LEAST_WORDS) {
            return Optional.of("a refusal is no sentence: " + complaint);
        }
        return isRefused && !isKept(read.sample().bytes(), folder)
                ? Optional.of("what was in the file is lost: " + complaint)
                : Optional.empty();
    }

    private static boolean isKept(byte[] bytes, Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                if (Files.isRegularFile(file)
                        && Files.size(file) == bytes.length
                        && Arrays.equals(Files.readAllBytes(file), bytes)) {
                    return true;
                }
            }
        }
        return false;
    }

    private long allocated() {
        return threads.getThreadAllocatedBytes(Thread.currentThread().getId());
    }

    private interface InFolder<T> {
        T make(Path folder) throws IOException;
    }

    /** Runs an action in a temporary folder. */
    private static <T> T inFolder(InFolder<T> work) {
        try {
            Path folder = Files.createTempDirectory("rigibo-fuzz");
            try {
                return work.make(folder);
            } finally {
                try (Stream<Path> all = Files.walk(folder)) {
                    for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
                        Files.deleteIfExists(path);
                    }
                }
            }
        } catch (IOException disk) {
            throw new UncheckedIOException(disk);
        }
    }
}

package rigibo.frontend.save;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Temporary files left by games that ended while writing. They are deleted when a game starts,
 * before it writes anything itself; even those with its own process number are then from an earlier
 * process.
 */
final class Leftovers {

    /** Names as {@link SafeFile} gives them: a file's own, then the process that writes it. */
    private static final Pattern NAME = Pattern.compile(".+\\.json\\.(\\d{1,18})");

    private Leftovers() {}

    /** Sweeps folders that need not exist; what cannot be swept now stays for the next start. */
    static void sweep(Stream<Path> folders) {
        folders.distinct().forEach(Leftovers::sweep);
    }

    private static void sweep(Path folder) {
        try {
            if (!in(folder).isEmpty()) {
                new FolderLock(folder, Duration.ZERO).during(() -> delete(in(folder)));
            }
        } catch (IOException | UncheckedIOException later) {
            // The files do no harm until the next start.
        }
    }

    private static void delete(List<Path> leftovers) throws IOException {
        for (Path leftover : leftovers) {
            Files.deleteIfExists(leftover);
        }
    }

    private static List<Path> in(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(Leftovers::isOfTheDead).toList();
        }
    }

    private static boolean isOfTheDead(Path file) {
        Matcher name = NAME.matcher(file.getFileName().toString());
        if (!name.matches()) {
            return false;
        }
        long writer = Long.parseLong(name.group(1));
        return writer == ProcessHandle.current().pid()
                || ProcessHandle.of(writer).filter(ProcessHandle::isAlive).isEmpty();
    }
}

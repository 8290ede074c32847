package rigibo.frontend.document;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;

/**
 * The JSON files of a folder, without those of folders in it, or of a zip file, in the order of
 * their names. A zip file is read as it stands: nothing is unpacked to the disk.
 */
public final class Pack {

    /** Most files of a pack. */
    static final int MOST_FILES = 200;

    /** Most bytes of all of its JSON files together. */
    static final int MOST_BYTES = 16_000_000;

    private static final String ENDING = ".json";

    private final Path place;
    private final List<Problem> errors;
    private final List<Entry> entries = new ArrayList<>();
    private int bytes;

    private Pack(Path place, List<Problem> errors) {
        this.place = place;
        this.errors = errors;
    }

    /**
     * A file of a pack.
     *
     * @param name its name in messages
     * @param text its content
     */
    public record Entry(String name, String text) {}

    /** The limits of a pack. */
    private static final class Refused extends IOException {
        private static final long serialVersionUID = 1;
        private final Cause cause;

        Refused(Cause cause, String words) {
            super(words);
            this.cause = cause;
        }
    }

    /** Whether a path is that of a pack, sound or not. */
    public static boolean is(Path file) {
        return Files.isDirectory(file) || file.toString().toLowerCase(Locale.ROOT).endsWith(".zip");
    }

    /**
     * The files of a pack.
     *
     * @param errors receives the problems of the pack, and of files that are not text
     */
    public static List<Entry> read(Path place, List<Problem> errors) {
        Pack pack = new Pack(place, errors);
        try {
            if (Files.isDirectory(place)) {
                pack.readFolder();
            } else {
                pack.readZip();
            }
            if (pack.entries.isEmpty() && errors.isEmpty()) {
                throw new Refused(Cause.EMPTY, "holds no file that ends with " + ENDING);
            }
        } catch (ZipException damaged) {
            String words = "is no zip file, or a damaged one: " + damaged.getMessage();
            errors.add(pack.problem(Cause.DAMAGED, words));
        } catch (Refused refused) {
            errors.add(pack.problem(refused.cause, refused.getMessage()));
        } catch (IOException broken) {
            errors.add(pack.problem(Cause.UNREADABLE, broken.getMessage()));
        } catch (IllegalArgumentException unnamable) {
            errors.add(pack.problem(Cause.CONTENT, "holds a file whose name is no UTF-8 text"));
        }
        return pack.entries;
    }

    private Problem problem(Cause cause, String why) {
        return Problem.ofWhole(place.toString(), cause, Fault.plain(why));
    }

    private void readFolder() throws IOException {
        try (Stream<Path> files = Files.list(place)) {
            List<Path> chosen =
                    files.filter(file -> isMeant(file.getFileName().toString())).sorted().toList();
            requireFew(chosen.size());
            for (Path file : chosen) {
                take(file.toString(), FileText.bytes(file));
            }
        }
    }

    private void readZip() throws IOException {
        try (ZipFile zip = new ZipFile(place.toFile())) {
            requireFew(zip.size());
            List<? extends ZipEntry> chosen =
                    zip.stream()
                            .filter(entry -> isMeant(entry.getName()))
                            .sorted(Comparator.comparing(ZipEntry::getName))
                            .toList();
            for (ZipEntry entry : chosen) {
                requireInside(entry.getName());
                try (InputStream in = zip.getInputStream(entry)) {
                    take(place + "/" + entry.getName(), in.readNBytes(Bounds.BYTES + 1));
                }
            }
        }
    }

    /** Leaves out what systems put beside files, whose names begin with a dot. */
    private static boolean isMeant(String name) {
        String last = name.substring(name.lastIndexOf('/') + 1);
        return last.endsWith(ENDING) && !last.startsWith(".");
    }

    private static void requireFew(int files) throws IOException {
        if (files > MOST_FILES) {
            String words = "holds " + files + " files, and a pack at most " + MOST_FILES;
            throw new Refused(Cause.TOO_LARGE, words);
        }
    }

    private static void requireInside(String name) throws IOException {
        boolean isOutside =
                name.startsWith("/")
                        || name.contains("\\")
                        || name.contains(":")
                        || List.of(name.split("/")).contains("..");
        if (isOutside) {
            String words = "holds \"" + name + "\", a path that leads out of the pack";
            throw new Refused(Cause.CONTENT, words);
        }
    }

    private void take(String name, byte[] content) throws IOException {
        bytes += content.length;
        if (bytes > MOST_BYTES) {
            throw new Refused(Cause.TOO_LARGE, "unpacks to more than " + MOST_BYTES + " bytes");
        }
        Problems problems = new Problems(name);
        Optional<String> text = FileText.decode(content, problems);
        text.ifPresent(one -> entries.add(new Entry(name, one)));
        errors.addAll(problems.inOrder());
    }
}

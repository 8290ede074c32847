package rigibo.frontend.puzzle.level;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;

/** Reads a file's text, whatever the file really is. */
public final class FileText {

    /** A level of 500 bodies takes about 100 kB; far above it a file is something else. */
    static final int MOST_BYTES = 1_000_000;

    private static final String BYTE_ORDER_MARK = "\uFEFF";

    private FileText() {}

    /** The text, or nothing after telling why there is none. */
    public static Optional<String> read(Path file, Problems problems) {
        try {
            return Files.isDirectory(file)
                    ? refused(problems, "cannot be read: it is a folder")
                    : decode(bytes(file), problems);
        } catch (NoSuchFileException missing) {
            return refused(problems, "cannot be read: there is no such file");
        } catch (AccessDeniedException denied) {
            return refused(problems, "cannot be read: permission denied");
        } catch (IOException broken) {
            return refused(problems, "cannot be read: " + broken.getMessage());
        }
    }

    /** At most one byte more than allowed: a device or a pipe may never end. */
    private static byte[] bytes(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return in.readNBytes(MOST_BYTES + 1);
        }
    }

    private static Optional<String> decode(byte[] bytes, Problems problems) {
        if (bytes.length > MOST_BYTES) {
            return refused(problems, "is larger than " + MOST_BYTES + " bytes, the most we read");
        }
        try {
            String text =
                    StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
            return Optional.of(
                    text.startsWith(BYTE_ORDER_MARK)
                            ? text.substring(BYTE_ORDER_MARK.length())
                            : text);
        } catch (CharacterCodingException broken) {
            return refused(problems, "is not UTF-8 text");
        }
    }

    private static Optional<String> refused(Problems problems, String why) {
        problems.error(Place.START, "", why);
        return Optional.empty();
    }
}

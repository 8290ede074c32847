package rigibo.frontend.document;

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

/** Reads the text of a file, whatever the file contains. */
public final class FileText {

    private static final String BYTE_ORDER_MARK = "\uFEFF";

    private FileText() {}

    /** Reads the text; returns nothing, after reporting the problem, if there is none. */
    public static Optional<String> read(Path file, Problems problems) {
        try {
            return decode(bytes(file), problems);
        } catch (NoSuchFileException missing) {
            return refused(problems, Cause.UNREADABLE, "cannot be read: there is no such file");
        } catch (AccessDeniedException denied) {
            return refused(problems, Cause.UNREADABLE, "cannot be read: permission denied");
        } catch (IOException broken) {
            return refused(problems, Cause.UNREADABLE, "cannot be read: " + broken.getMessage());
        }
    }

    /**
     * Reads a file, at most one byte more than {@link #decode} accepts.
     *
     * @throws IOException when it cannot be read, or is a folder, a device or a pipe; reading from
     *     a device or a pipe might never end
     */
    public static byte[] bytes(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new IOException("it is a folder");
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new IOException("it is no ordinary file");
        }
        try (InputStream in = Files.newInputStream(file)) {
            return in.readNBytes(Bounds.BYTES + 1);
        }
    }

    /**
     * Decodes the text of bytes; returns nothing, after reporting the problem, if they are no text.
     */
    public static Optional<String> decode(byte[] bytes, Problems problems) {
        if (bytes.length > Bounds.BYTES) {
            String words = "is larger than " + Bounds.BYTES + " bytes, the most we read";
            return refused(problems, Cause.TOO_LARGE, words);
        }
        try {
            String text =
                    StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
            return Optional.of(
                    text.startsWith(BYTE_ORDER_MARK)
                            ? text.substring(BYTE_ORDER_MARK.length())
                            : text);
        } catch (CharacterCodingException broken) {
            return refused(problems, Cause.DAMAGED, "is not UTF-8 text");
        }
    }

    private static Optional<String> refused(Problems problems, Cause cause, String why) {
        problems.refuse(cause, why);
        return Optional.empty();
    }
}

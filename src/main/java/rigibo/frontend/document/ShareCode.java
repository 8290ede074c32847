package rigibo.frontend.document;

import tools.jackson.databind.JsonNode;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/**
 * A JSON document as a text short enough for a message: a word for its kind, then its checksum and
 * the compressed document (RFC 1951) in base64url (RFC 4648, 5).
 *
 * @param kind kind of the document
 * @param text the document; its reader has to check it
 */
public record ShareCode(Kind kind, String text) {

    /** Most letters of a code: more are too many to be pasted anywhere. */
    public static final int MOST_LETTERS = 2_000;

    /** The name of a code in messages. */
    public static final String NAME = "code";

    private static final String START = "RIGIBO-";

    /** B of the checksum. */
    private static final int CHECKSUM = 4;

    /** The kinds of codes. */
    public enum Kind {
        LEVEL,
        REPLAY;

        private String start() {
            return START + name() + "-";
        }
    }

    /** The code of a document; empty if it would have more letters than a code may. */
    public static Optional<String> of(Kind kind, JsonNode document) {
        byte[] text = document.toString().getBytes(StandardCharsets.UTF_8);
        byte[] packed = pack(text);
        ByteBuffer bytes = ByteBuffer.allocate(CHECKSUM + packed.length);
        bytes.putInt(checksum(text)).put(packed);
        String code =
                kind.start()
                        + Base64.getUrlEncoder().withoutPadding().encodeToString(bytes.array());
        return Optional.of(code).filter(letters -> letters.length() <= MOST_LETTERS);
    }

    /** Whether a text looks like a code, a damaged one perhaps. */
    public static boolean isMeantBy(String pasted) {
        return pasted.stripLeading().regionMatches(true, 0, START, 0, START.length());
    }

    /**
     * Reads a code, which messages may have broken into lines; returns nothing, after reporting the
     * problem, if it is none.
     */
    public static Optional<ShareCode> read(String pasted, Problems problems) {
        String letters = pasted.replaceAll("\\s", "");
        if (letters.length() > MOST_LETTERS) {
            String words = "has %,d letters, and a code at most %,d";
            return refused(
                    problems,
                    Cause.TOO_LARGE,
                    String.format(Locale.ROOT, words, letters.length(), MOST_LETTERS));
        }
        for (Kind kind : Kind.values()) {
            String start = kind.start();
            if (letters.regionMatches(true, 0, start, 0, start.length())) {
                return text(letters.substring(start.length()), problems)
                        .map(text -> new ShareCode(kind, text));
            }
        }
        String known = Kind.LEVEL.start() + " or " + Kind.REPLAY.start();
        String words = "must begin with " + known + ", as codes of this version do";
        return refused(problems, Cause.DAMAGED, words);
    }

    private static Optional<String> text(String letters, Problems problems) {
        byte[] bytes;
        try {
            bytes = Base64.getUrlDecoder().decode(letters);
        } catch (IllegalArgumentException unknown) {
            return damaged(problems);
        }
        if (bytes.length <= CHECKSUM) {
            return damaged(problems);
        }
        byte[] text;
        try {
            text = unpack(Arrays.copyOfRange(bytes, CHECKSUM, bytes.length));
        } catch (DataFormatException cut) {
            return damaged(problems);
        }
        if (text.length <= Bounds.BYTES && checksum(text) != ByteBuffer.wrap(bytes).getInt()) {
            return damaged(problems);
        }
        return FileText.decode(text, problems);
    }

    private static Optional<String> damaged(Problems problems) {
        return refused(problems, Cause.DAMAGED, "is damaged: a letter is missing, or was changed");
    }

    private static <T> Optional<T> refused(Problems problems, Cause cause, String why) {
        problems.refuse(cause, why);
        return Optional.empty();
    }

    private static int checksum(byte[] text) {
        CRC32 sum = new CRC32();
        sum.update(text);
        return (int) sum.getValue();
    }

    private static byte[] pack(byte[] text) {
        Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION, true);
        deflater.setInput(text);
        deflater.finish();
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        byte[] some = new byte[1024];
        while (!deflater.finished()) {
            packed.write(some, 0, deflater.deflate(some));
        }
        deflater.end();
        return packed.toByteArray();
    }

    /** Unpacks at most one byte more than a file may have, whatever a stranger has packed. */
    private static byte[] unpack(byte[] packed) throws DataFormatException {
        Inflater inflater = new Inflater(true);
        inflater.setInput(packed);
        byte[] text = new byte[1024];
        int count = 0;
        try {
            while (!inflater.finished() && count <= Bounds.BYTES) {
                if (count == text.length) {
                    text = Arrays.copyOf(text, Math.min(2 * count, Bounds.BYTES + 1));
                }
                int more = inflater.inflate(text, count, text.length - count);
                if (more == 0) {
                    throw new DataFormatException("the end is missing");
                }
                count += more;
            }
            if (inflater.getRemaining() > 0 && count <= Bounds.BYTES) {
                throw new DataFormatException("something follows the end");
            }
        } finally {
            inflater.end();
        }
        return Arrays.copyOf(text, count);
    }
}

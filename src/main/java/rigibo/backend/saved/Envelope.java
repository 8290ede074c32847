package rigibo.backend.saved;

import java.util.Arrays;

/**
 * The header of a snapshot: origin, format, length, and a checksum over these and the content. A
 * change within one eight-byte word of the checksum is always detected; any other is missed with a
 * probability of one in 2⁶⁴.
 */
final class Envelope {

    /**
     * To be raised when the meaning of the written bytes changes; columns have names of their own.
     */
    static final int VERSION = 11;

    /** "RigiBo" and both line ends, which reveal a transfer as text that replaced line ends. */
    private static final long MAGIC = 0x5269_6769_426F_0D0AL;

    private static final int CHECKSUM_AT = 16;
    private static final int HEADER_BYTES = 24;

    private Envelope() {}

    /** Puts the header in front of the content. */
    static byte[] seal(byte[] content) {
        ByteWriter header = new ByteWriter();
        header.word(MAGIC);
        header.number(VERSION);
        header.number(HEADER_BYTES + content.length);
        header.word(0);
        byte[] bytes = Arrays.copyOf(header.bytes(), HEADER_BYTES + content.length);
        System.arraycopy(content, 0, bytes, HEADER_BYTES, content.length);
        ByteWriter checksum = new ByteWriter();
        checksum.word(checksum(bytes));
        System.arraycopy(checksum.bytes(), 0, bytes, CHECKSUM_AT, Long.BYTES);
        return bytes;
    }

    /**
     * Checks the header and returns a reader of the content.
     *
     * @throws IllegalArgumentException when the header or the checksum is not that of a snapshot
     */
    static ByteReader open(byte[] bytes) {
        if (bytes.length < HEADER_BYTES) {
            throw new IllegalArgumentException(
                    "must have " + HEADER_BYTES + " bytes or more, was " + bytes.length);
        }
        ByteReader reader = new ByteReader(bytes);
        if (reader.word() != MAGIC) {
            throw new IllegalArgumentException("must begin as one that RigiBo wrote, does not");
        }
        int version = reader.number(0);
        if (version > VERSION) {
            throw new IllegalArgumentException(
                    "must be of a format up to "
                            + VERSION
                            + ", was "
                            + version
                            + ": a newer version wrote it");
        }
        requireEqual("be of format", VERSION, version);
        requireEqual("be whole, with so many bytes:", reader.number(0), bytes.length);
        requireEqual("be unaltered, with the checksum", reader.word(), checksum(bytes));
        return reader;
    }

    private static void requireEqual(String what, long expected, long found) {
        if (expected != found) {
            throw new IllegalArgumentException("must " + what + " " + expected + ", was " + found);
        }
    }

    /** Checksum of all bytes except its own, as words; the last word is padded with 0. */
    private static long checksum(byte[] bytes) {
        byte[] padded = Arrays.copyOf(bytes, (bytes.length + Long.BYTES - 1) & -Long.BYTES);
        ByteReader reader = new ByteReader(padded);
        long hash = Bits.SEED;
        for (int at = 0; at < padded.length; at += Long.BYTES) {
            long word = reader.word();
            hash = at == CHECKSUM_AT ? hash : Bits.fold(hash, word);
        }
        return hash;
    }
}

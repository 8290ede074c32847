package rigibo.fuzz.program;

import rigibo.fuzz.chance.Chance;

import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * A change to a snapshot, by a bad disk or on purpose: bytes changed, left out or repeated, with
 * the old length and checksum or with matching ones.
 *
 * @param seed the same does the same
 */
public record Alteration(long seed) {

    /** The places of the length, the checksum and the content in a snapshot. */
    private static final int LENGTH_AT = 12;

    private static final int CHECKSUM_AT = 16;
    private static final int HEADER_BYTES = 24;

    /** The constants of the checksum, as in {@code storage.Bits}. */
    private static final long SEED = 0x243F6A8885A308D3L;

    private static final long ODD = 0x9E3779B97F4A7C15L;

    /** An altered copy of bytes. */
    public byte[] of(byte[] snapshot) {
        Chance chance = Chance.of(seed, 0);
        byte[] altered = snapshot.clone();
        for (int left = chance.whole(1, 3); left > 0; left--) {
            altered = once(altered, chance);
        }
        return chance.happens(0.8) ? sealed(altered) : altered;
    }

    private static byte[] once(byte[] bytes, Chance chance) {
        if (bytes.length <= HEADER_BYTES + Long.BYTES) {
            return bytes;
        }
        int at = chance.whole(HEADER_BYTES, bytes.length - 1);
        switch (chance.whole(0, 5)) {
            case 0 -> bytes[at] ^= (byte) (1 << chance.whole(0, Byte.SIZE - 1));
            case 1 -> bytes[at] = (byte) chance.whole(Byte.MIN_VALUE, Byte.MAX_VALUE);
            case 2 -> putNumber(bytes, at, chance);
            case 3 -> putDouble(bytes, at, chance);
            case 4 -> {
                return Arrays.copyOf(bytes, at);
            }
            default -> {
                return repeated(bytes, at, chance.whole(1, Math.min(100, bytes.length - at)));
            }
        }
        return bytes;
    }

    private static void putNumber(byte[] bytes, int at, Chance chance) {
        int place = Math.min(at, bytes.length - Integer.BYTES);
        int number = chance.oneOf(-1, 0, 1, 1000, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 20);
        ByteBuffer.wrap(bytes).putInt(place, number);
    }

    private static void putDouble(byte[] bytes, int at, Chance chance) {
        int place = Math.min(at, bytes.length - Double.BYTES);
        double number =
                chance.oneOf(chance.notFinite(), 0.0, -1.0, 1e300, -1e300, 1e-300, 1e9, 0.5);
        ByteBuffer.wrap(bytes).putDouble(place, number);
    }

    private static byte[] repeated(byte[] bytes, int at, int count) {
        byte[] longer = Arrays.copyOf(bytes, bytes.length + count);
        System.arraycopy(bytes, at, longer, at + count, bytes.length - at);
        return longer;
    }

    /** Corrects length and checksum, so that the content itself is read. */
    static byte[] sealed(byte[] bytes) {
        if (bytes.length < HEADER_BYTES) {
            return bytes;
        }
        ByteBuffer buffer = ByteBuffer.wrap(bytes);
        buffer.putInt(LENGTH_AT, bytes.length);
        buffer.putLong(CHECKSUM_AT, checksum(bytes));
        return bytes;
    }

    private static long checksum(byte[] bytes) {
        int words = (bytes.length + Long.BYTES - 1) / Long.BYTES;
        ByteBuffer padded = ByteBuffer.wrap(Arrays.copyOf(bytes, words * Long.BYTES));
        long hash = SEED;
        for (int at = 0; at < padded.capacity(); at += Long.BYTES) {
            if (at != CHECKSUM_AT) {
                long mixed = Long.rotateLeft(hash ^ padded.getLong(at), 27) * ODD;
                hash = mixed ^ mixed >>> 29;
            }
        }
        return hash;
    }
}

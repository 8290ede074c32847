package rigibo.fuzz.file;

import rigibo.fuzz.chance.Chance;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Mutations that a bad disk, a wrong program or an attacker might cause. */
final class Mutation {

    private static final byte[] BYTE_ORDER_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};

    private final Chance chance;

    Mutation(Chance chance) {
        this.chance = chance;
    }

    /** The mutated bytes of a file. */
    byte[] of(byte[] whole) {
        return switch (chance.whole(0, 9)) {
            case 0 -> flipped(whole.clone());
            case 1 -> Arrays.copyOf(whole, chance.whole(0, whole.length));
            case 2 -> repeated(whole);
            case 3 -> encoded(whole);
            default -> new JsonMutation(chance).of(whole);
        };
    }

    private byte[] flipped(byte[] bytes) {
        for (int left = chance.oneOf(1, 2, 10, bytes.length); left > 0; left--) {
            int at = chance.whole(0, bytes.length - 1);
            bytes[at] =
                    chance.happens(0.5)
                            ? (byte) (bytes[at] ^ 1 << chance.whole(0, Byte.SIZE - 1))
                            : (byte) chance.whole(Byte.MIN_VALUE, Byte.MAX_VALUE);
        }
        return bytes;
    }

    /** Repeats a part of it, or the whole. */
    private byte[] repeated(byte[] whole) {
        int from = chance.happens(0.3) ? 0 : chance.whole(0, whole.length - 1);
        int to = chance.happens(0.3) ? whole.length : chance.whole(from, whole.length);
        return joined(
                joined(Arrays.copyOf(whole, to), Arrays.copyOfRange(whole, from, to)),
                Arrays.copyOfRange(whole, to, whole.length));
    }

    /** Changes the encoding to one of other programs, or to an invalid one. */
    private byte[] encoded(byte[] whole) {
        String text = new String(whole, StandardCharsets.UTF_8);
        return switch (chance.whole(0, 7)) {
            case 0 -> text.getBytes(StandardCharsets.UTF_16);
            case 1 -> text.getBytes(StandardCharsets.UTF_16LE);
            case 2 -> text.getBytes(Charset.forName("UTF-32"));
            case 3 -> joined(BYTE_ORDER_MARK, whole);
            case 4 -> new byte[chance.whole(0, 1000)];
            case 5 -> " \n".repeat(chance.whole(0, 1000)).getBytes(StandardCharsets.UTF_8);
            case 6 -> noise(chance.whole(0, 2000));
            default -> withInvalid(whole);
        };
    }

    private byte[] noise(int count) {
        byte[] bytes = new byte[count];
        for (int i = 0; i < count; i++) {
            bytes[i] = (byte) chance.whole(Byte.MIN_VALUE, Byte.MAX_VALUE);
        }
        return bytes;
    }

    /** An invalid UTF-8 sequence: truncated, overlong, a surrogate, or out of range. */
    private byte[] withInvalid(byte[] whole) {
        byte[] invalid =
                chance.oneOf(
                        new byte[] {(byte) 0xC3},
                        new byte[] {(byte) 0xC0, (byte) 0x80},
                        new byte[] {(byte) 0xED, (byte) 0xA0, (byte) 0x80},
                        new byte[] {(byte) 0xF8, (byte) 0x88, (byte) 0x80, (byte) 0x80},
                        new byte[] {(byte) 0xFF, (byte) 0xFE});
        int at = chance.whole(0, whole.length);
        return joined(
                joined(Arrays.copyOf(whole, at), invalid),
                Arrays.copyOfRange(whole, at, whole.length));
    }

    private static byte[] joined(byte[] first, byte[] second) {
        byte[] both = Arrays.copyOf(first, first.length + second.length);
        System.arraycopy(second, 0, both, first.length, second.length);
        return both;
    }
}

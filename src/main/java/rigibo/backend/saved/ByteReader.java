package rigibo.backend.saved;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads bytes of a {@link ByteWriter}, and rejects with {@link IllegalArgumentException} anything
 * that it cannot have written. Equal shapes and materials become one object.
 */
final class ByteReader implements Codec {

    private static final int NUMBER_BYTES = 4;
    private static final int WORD_BYTES = 8;
    private static final int UNIT_BYTES = 2;

    private final byte[] bytes;
    private final Map<Stated, Object> known = new HashMap<>();
    private int at;
    private String label = "";

    private record Stated(Form<?> form, List<Double> numbers) {}

    ByteReader(byte[] bytes) {
        this.bytes = bytes;
    }

    @Override
    public void label(String name) {
        StringBuilder found = new StringBuilder();
        for (int left = octet(); left > 0; left--) {
            found.append((char) octet());
        }
        if (!found.toString().equals(name)) {
            throw new IllegalArgumentException(
                    "must have '" + name + "' after '" + label + "', was '" + found + "'");
        }
        label = name;
    }

    @Override
    public int number(int ignored) {
        int value = 0;
        for (int i = 0; i < NUMBER_BYTES; i++) {
            value = value << 8 | octet();
        }
        return value;
    }

    @Override
    public double number(double ignored) {
        return Double.longBitsToDouble(word());
    }

    long word() {
        long high = number(0);
        return high << 32 | number(0) & 0xFFFF_FFFFL;
    }

    @Override
    public boolean flag(boolean ignored) {
        int value = octet();
        if (value > 1) {
            throw new IllegalArgumentException("must have 0 or 1 in '" + label + "', was " + value);
        }
        return value == 1;
    }

    @Override
    public String text(String ignored) {
        int length = count(0, UNIT_BYTES);
        StringBuilder value = new StringBuilder(length);
        for (int i = 0; i < length; i++) {
            value.append((char) (octet() << 8 | octet()));
        }
        return value.toString();
    }

    /**
     * Never more than the remaining bytes can hold, so that altered bytes cannot make the caller
     * allocate for nothing.
     */
    @Override
    public int count(int ignored, int leastBytes) {
        int entries = number(0);
        int most = (bytes.length - at) / leastBytes;
        if (entries < 0 || entries > most) {
            throw new IllegalArgumentException(
                    "must have at most " + most + " entries of '" + label + "', was " + entries);
        }
        return entries;
    }

    @Override
    public <T> T value(Form<T> form, T ignored) {
        int length = count(0, WORD_BYTES);
        if (form.count() != Form.ANY && form.count() != length) {
            throw new IllegalArgumentException(
                    "must have "
                            + form.count()
                            + " numbers for a "
                            + form.name()
                            + ", was "
                            + length);
        }
        List<Double> numbers = new ArrayList<>(length);
        for (int i = 0; i < length; i++) {
            numbers.add(number(0.0));
        }
        return made(form, numbers);
    }

    /** One object for equal numbers, so that a pile of equal boxes shares one shape. */
    @SuppressWarnings("unchecked")
    private <T> T made(Form<T> form, List<Double> numbers) {
        return (T)
                known.computeIfAbsent(
                        new Stated(form, numbers),
                        stated ->
                                form.maker()
                                        .apply(
                                                numbers.stream()
                                                        .mapToDouble(Double::doubleValue)
                                                        .toArray()));
    }

    /** Rejects bytes that are left over. */
    void requireEnd() {
        if (at != bytes.length) {
            throw new IllegalArgumentException(
                    "must end after '" + label + "', had " + (bytes.length - at) + " bytes more");
        }
    }

    private int octet() {
        if (at == bytes.length) {
            throw new IllegalArgumentException("must not end within '" + label + "', but does");
        }
        return bytes[at++] & 0xFF;
    }
}

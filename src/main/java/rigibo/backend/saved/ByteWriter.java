package rigibo.backend.saved;

import java.util.Arrays;

/** Writes a state as bytes, numbers in big-endian order. */
final class ByteWriter implements Codec {

    private byte[] bytes = new byte[1 << 12];
    private int size;

    /** All bytes written so far. */
    byte[] bytes() {
        return Arrays.copyOf(bytes, size);
    }

    @Override
    public void label(String name) {
        octet(name.length());
        name.chars().forEach(this::octet);
    }

    @Override
    public int number(int value) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            octet(value >>> shift);
        }
        return value;
    }

    @Override
    public double number(double value) {
        word(Double.doubleToRawLongBits(value));
        return value;
    }

    void word(long value) {
        number((int) (value >>> 32));
        number((int) value);
    }

    @Override
    public boolean flag(boolean value) {
        octet(value ? 1 : 0);
        return value;
    }

    /** Written as UTF-16, which also keeps unpaired surrogates. */
    @Override
    public String text(String value) {
        number(value.length());
        value.chars()
                .forEach(
                        unit -> {
                            octet(unit >>> 8);
                            octet(unit);
                        });
        return value;
    }

    @Override
    public int count(int entries, int leastBytes) {
        return number(entries);
    }

    @Override
    public <T> T value(Form<T> form, T value) {
        double[] numbers = form.numbers().apply(value);
        assert form.count() == Form.ANY || form.count() == numbers.length;
        number(numbers.length);
        for (double number : numbers) {
            number(number);
        }
        return value;
    }

    private void octet(int value) {
        if (size == bytes.length) {
            bytes = Arrays.copyOf(bytes, 2 * size);
        }
        bytes[size++] = (byte) value;
    }
}

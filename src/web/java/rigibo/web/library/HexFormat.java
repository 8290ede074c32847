package rigibo.web.library;

/** Hexadecimal digits. */
public final class HexFormat {

    private static final HexFormat LOWER_CASE = new HexFormat();

    private HexFormat() {}

    public static HexFormat of() {
        return LOWER_CASE;
    }

    /** All sixteen digits of a number. */
    public String toHexDigits(long value) {
        String digits = Long.toHexString(value);
        return "0".repeat(Long.BYTES * 2 - digits.length()) + digits;
    }

    public static long fromHexDigitsToLong(CharSequence digits) {
        return Missing.parseUnsignedLong(digits.toString(), 16);
    }
}

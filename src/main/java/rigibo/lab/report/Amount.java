package rigibo.lab.report;

import java.util.Locale;

/** Formats numbers for people, with three significant digits and the most readable unit. */
public final class Amount {

    private static final String[] TIMES = {"ns", "µs", "ms", "s"};

    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    private Amount() {}

    /** A time in ns, possibly negative, such as {@code 12.3 µs}. */
    public static String time(double nanos) {
        int unit = 0;
        double value = nanos;
        while (Math.abs(value) >= 999.5 && unit < TIMES.length - 1) {
            value /= 1000;
            unit++;
        }
        return digits(value) + " " + TIMES[unit];
    }

    /** A time in ns with its sign, such as {@code +12.3 µs}. */
    public static String signedTime(double nanos) {
        return (nanos > 0 ? "+" : "") + time(nanos);
    }

    /** A range of times in ns, such as {@code 1.23 µs to 1.31 µs}. */
    public static String times(double low, double high) {
        return time(low) + " to " + time(high);
    }

    /** A number below 1000 with three significant digits. */
    public static String digits(double value) {
        double size = Math.abs(value);
        int decimals = size >= 99.95 ? 0 : size >= 9.995 ? 1 : 2;
        return signed("%." + decimals + "f", value);
    }

    /** A ratio such as {@code 1.0012}. */
    public static String ratio(double value) {
        return signed("%.4f", value);
    }

    /** A percentage such as {@code 12.3}. */
    public static String percent(double value) {
        return signed("%.1f", value);
    }

    /** A positive number of any size with two significant digits, such as {@code 1.2 × 10⁻³}. */
    public static String scientific(double value) {
        if (value == 0) {
            return "0";
        }
        String[] parts = String.format(Locale.ROOT, "%.1e", value).split("e");
        int power = Integer.parseInt(parts[1]);
        return power >= -1 && power <= 2
                ? plain(Double.parseDouble(parts[0] + "e" + power), power)
                : parts[0] + " × " + power(power);
    }

    private static String plain(double value, int power) {
        return String.format(Locale.ROOT, "%." + Math.max(0, 1 - power) + "f", value);
    }

    /** A power of ten, such as {@code 10⁻³}. */
    public static String power(int power) {
        StringBuilder raised = new StringBuilder("10");
        for (char letter : Integer.toString(power).toCharArray()) {
            raised.append(letter == '-' ? '⁻' : RAISED.charAt(letter - '0'));
        }
        return raised.toString();
    }

    /** A round time in s, such as {@code 10 µs}. */
    public static String roundTime(double seconds) {
        return time(seconds * 1e9).replaceFirst("\\.0+ ", " ");
    }

    /** Uses a true minus sign, and none before zero. */
    private static String signed(String format, double value) {
        String digits = String.format(Locale.ROOT, format, value);
        boolean isZero = digits.matches("-[0.]+");
        return isZero ? digits.substring(1) : digits.replace('-', '−');
    }
}

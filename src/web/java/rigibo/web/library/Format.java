package rigibo.web.library;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Texts with values in them, as {@code String.format} makes them of what the game's formats ask.
 */
final class Format {

    /** Flags, width, digits after the point, kind. */
    private static final Pattern PLACE =
            Pattern.compile("%([-+,0]*)(\\d*)(?:\\.(\\d+))?([a-zA-Z%])");

    /** Digits after the point where a format states none. */
    private static final int USUAL = 6;

    /** Digits of a group. */
    private static final int GROUP = 3;

    private final Locale locale;

    Format(Locale locale) {
        this.locale = locale;
    }

    String of(String format, Object... values) {
        StringBuilder text = new StringBuilder();
        Matcher place = PLACE.matcher(format);
        int end = 0;
        int next = 0;
        while (place.find()) {
            text.append(format, end, place.start());
            end = place.end();
            char kind = place.group(4).charAt(0);
            if (kind == '%' || kind == 'n') {
                text.append(kind == '%' ? "%" : "\n");
            } else {
                text.append(padded(place, value(place, kind, values[next++])));
            }
        }
        return text.append(format.substring(end)).toString();
    }

    private String value(Matcher place, char kind, Object value) {
        String flags = place.group(1);
        int digits = place.group(3) == null ? USUAL : Integer.parseInt(place.group(3));
        return switch (kind) {
            case 's', 'b', 'c' -> String.valueOf(value);
            case 'd' -> signed(flags, grouped(flags, value.toString()));
            case 'x' -> Long.toHexString(((Number) value).longValue());
            case 'f' -> signed(flags, grouped(flags, fixed((Number) value, digits)));
            case 'e' -> signed(flags, scientific((Number) value, digits));
            default -> throw new IllegalArgumentException("no value is written by %" + kind);
        };
    }

    private static String signed(String flags, String number) {
        return flags.contains("+") && !number.startsWith("-") ? "+" + number : number;
    }

    private String fixed(Number value, int digits) {
        double number = value.doubleValue();
        if (Double.isNaN(number) || Double.isInfinite(number)) {
            return value.toString();
        }
        String size =
                new BigDecimal(Double.toString(Math.abs(number)))
                        .setScale(digits, RoundingMode.HALF_UP)
                        .toPlainString();
        return sign(number) + (isGerman() ? size.replace('.', ',') : size);
    }

    private static String scientific(Number value, int digits) {
        double number = value.doubleValue();
        if (Double.isNaN(number) || Double.isInfinite(number)) {
            return value.toString();
        }
        BigDecimal rounded =
                new BigDecimal(Double.toString(Math.abs(number)))
                        .round(new MathContext(digits + 1, RoundingMode.HALF_UP));
        StringBuilder all = new StringBuilder(rounded.unscaledValue().toString());
        int exponent = number == 0 ? 0 : all.length() - 1 - rounded.scale();
        while (all.length() < digits + 1) {
            all.append('0');
        }
        all.setLength(digits + 1);
        if (digits > 0) {
            all.insert(1, '.');
        }
        String size = Integer.toString(Math.abs(exponent));
        return sign(number)
                + all
                + (exponent < 0 ? "e-" : "e+")
                + (size.length() < 2 ? "0" : "")
                + size;
    }

    private static String sign(double number) {
        return number < 0 || 1 / number < 0 ? "-" : "";
    }

    private boolean isGerman() {
        return locale.getLanguage().equals("de");
    }

    private String grouped(String flags, String number) {
        if (!flags.contains(",")) {
            return number;
        }
        int begin = number.startsWith("-") ? 1 : 0;
        int point = number.indexOf(isGerman() ? ',' : '.');
        StringBuilder text = new StringBuilder(number);
        for (int at = (point < 0 ? number.length() : point) - GROUP; at > begin; at -= GROUP) {
            text.insert(at, isGerman() ? '.' : ',');
        }
        return text.toString();
    }

    private static String padded(Matcher place, String value) {
        int width = place.group(2).isEmpty() ? 0 : Integer.parseInt(place.group(2));
        String flags = place.group(1);
        String padding =
                (flags.contains("0") ? "0" : " ").repeat(Math.max(0, width - value.length()));
        return flags.contains("-") ? value + padding : padding + value;
    }
}

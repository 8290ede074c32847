package rigibo.web.library;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Formats texts with values like {@code String.format}, as far as the game's formats need it. */
final class Format {

    /** Flags, width, digits after the point, kind. */
    private static final Pattern PLACE =
            Pattern.compile("%([-+,0]*)(\\d*)(?:\\.(\\d+))?([a-zA-Z%])");

    /** Default number of digits after the point. */
    private static final int USUAL = 6;

    /** Digits of a group. */
    private static final int GROUP = 3;

    /** The places of each format used so far; there are few, used again and again. */
    private static final Map<String, List<Place>> KNOWN = new HashMap<>();

    private final Locale locale;

    Format(Locale locale) {
        this.locale = locale;
    }

    /** The position of a value in a format, and its style. */
    private record Place(int begin, int end, String flags, int width, int digits, char kind) {

        static List<Place> of(String format) {
            List<Place> places = new ArrayList<>();
            Matcher found = PLACE.matcher(format);
            while (found.find()) {
                places.add(
                        new Place(
                                found.start(),
                                found.end(),
                                found.group(1),
                                number(found.group(2), 0),
                                number(found.group(3), USUAL),
                                found.group(4).charAt(0)));
            }
            return places;
        }

        private static int number(String digits, int otherwise) {
            return digits == null || digits.isEmpty() ? otherwise : Integer.parseInt(digits);
        }

        String padded(String value) {
            String padding =
                    (flags.contains("0") ? "0" : " ").repeat(Math.max(0, width - value.length()));
            return flags.contains("-") ? value + padding : padding + value;
        }
    }

    String of(String format, Object... values) {
        StringBuilder text = new StringBuilder();
        int end = 0;
        int next = 0;
        for (Place place : KNOWN.computeIfAbsent(format, Place::of)) {
            text.append(format, end, place.begin);
            end = place.end;
            if (place.kind == '%' || place.kind == 'n') {
                text.append(place.kind == '%' ? "%" : "\n");
            } else {
                text.append(place.padded(value(place, values[next++])));
            }
        }
        return text.append(format.substring(end)).toString();
    }

    private String value(Place place, Object value) {
        String flags = place.flags;
        return switch (place.kind) {
            case 's', 'b', 'c' -> String.valueOf(value);
            case 'd' -> signed(flags, grouped(flags, value.toString()));
            case 'x' -> Long.toHexString(((Number) value).longValue());
            case 'f' -> signed(flags, grouped(flags, fixed((Number) value, place.digits)));
            case 'e' -> signed(flags, scientific((Number) value, place.digits));
            default -> throw new IllegalArgumentException("no value is written by %" + place.kind);
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
}

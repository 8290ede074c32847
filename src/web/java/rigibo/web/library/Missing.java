package rigibo.web.library;

import org.teavm.jso.JSBody;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.text.Normalizer;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.stream.Stream;

/**
 * Methods called in place of those of the same name and class that the library lacks; the object of
 * the call is the first argument.
 */
public final class Missing {

    /** Factors from degrees to radians and back, rounded as in Java. */
    private static final double RADIANS = 0.017453292519943295;

    private static final double DEGREES = 57.29577951308232;

    private Missing() {}

    /** Replaces a method of {@link String}, whose own form knows no floating point. */
    public static String format(String format, Object... values) {
        return format(Locale.ROOT, format, values);
    }

    /** Replaces a method of {@link String}. */
    public static String format(Locale locale, String format, Object... values) {
        return new Format(locale).of(format, values);
    }

    /** Replaces a method of {@link Locale}. */
    public static Locale forLanguageTag(String language) {
        return new Locale(language);
    }

    /** Replaces a method of {@link Character}. */
    public static String toString(int codePoint) {
        return new String(Character.toChars(codePoint));
    }

    /** Replaces a method of {@link Math}, whose own form divides and so rounds otherwise. */
    public static double toRadians(double degrees) {
        return degrees * RADIANS;
    }

    /** Replaces a method of {@link Math}. */
    public static double toDegrees(double radians) {
        return radians * DEGREES;
    }

    /** Replaces a method of {@link Normalizer}. */
    public static String normalize(CharSequence text, Normalizer.Form form) {
        return normalized(text.toString(), form.name());
    }

    @JSBody(
            params = {"text", "form"},
            script = "return text.normalize(form);")
    private static native String normalized(String text, String form);

    /** Replaces a method of {@link Character}. */
    public static String toString(char letter) {
        return String.valueOf(letter);
    }

    /** Replaces a method of {@link Collections}, whose own form draws in another order. */
    public static <T> void shuffle(List<T> values, Random random) {
        for (int i = values.size(); i > 1; i--) {
            Collections.swap(values, i - 1, random.nextInt(i));
        }
    }

    /** Replaces a method of {@link Collections}. */
    public static <K, V> SortedMap<K, V> emptySortedMap() {
        return new TreeMap<>();
    }

    /**
     * Replaces a method of {@link Collections}. It returns the map itself; the desktop's tests find
     * code that changes it.
     */
    public static <K, V> SortedMap<K, V> unmodifiableSortedMap(SortedMap<K, V> map) {
        return map;
    }

    /** Replaces a method of {@link Long}. */
    public static long parseUnsignedLong(String digits, int radix) {
        long value = 0;
        for (int i = 0; i < digits.length(); i++) {
            value = radix * value + Character.digit(digits.charAt(i), radix);
        }
        return value;
    }

    /** Replaces a method of {@link Matcher}. */
    public static String replaceAll(Matcher matcher, Function<MatchResult, String> replacement) {
        StringBuffer replaced = new StringBuffer();
        while (matcher.find()) {
            matcher.appendReplacement(replaced, replacement.apply(matcher));
        }
        return matcher.appendTail(replaced).toString();
    }

    /** Replaces a method of {@link String}. */
    public static Stream<String> lines(String text) {
        return Arrays.stream(text.split("\r?\n"));
    }

    /** Replaces a method of {@link Files}, whose own form calls a missing method. */
    public static String readString(Path file) throws IOException {
        return readString(file, StandardCharsets.UTF_8);
    }

    /** Replaces a method of {@link Files}. */
    public static String readString(Path file, Charset charset) throws IOException {
        return new String(Files.readAllBytes(file), charset);
    }

    /** Of {@link Files}, whose own form refuses a folder of the root that is there already. */
    public static Path createDirectories(Path folder, FileAttribute<?>... attributes)
            throws IOException {
        return Files.isDirectory(folder) ? folder : Files.createDirectories(folder, attributes);
    }

    /** Of {@link List}; there is one thread. */
    public static <T> Stream<T> parallelStream(List<T> values) {
        return values.stream();
    }

    /** Of {@link Class}. */
    public static String getPackageName(Class<?> type) {
        String name = type.getName();
        return name.substring(0, Math.max(0, name.lastIndexOf('.')));
    }
}

package rigibo.lab.child;

import java.lang.reflect.AccessibleObject;
import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/**
 * Records as lines of text, which processes print and logs keep. A line holds the components in
 * their order: numbers, words, enum constants, arrays and maps of numbers. A nested record is
 * replaced by its own components.
 */
public final class Fields {

    private static final String BETWEEN = "\t";
    private static final String BETWEEN_NUMBERS = " ";
    private static final String BETWEEN_NAMED = ";";
    private static final String AFTER_NAME = "=";

    private static final Map<Class<?>, Function<String, Object>> READERS =
            Map.of(
                    int.class, Integer::valueOf,
                    long.class, Long::valueOf,
                    double.class, Double::valueOf,
                    double[].class, Fields::numbers,
                    Map.class, Fields::named,
                    String.class, word -> word);

    private Fields() {}

    /** The values of a record, with a nested record replaced by its own values. */
    public static Stream<Object> of(Record record) {
        return Stream.of(record.getClass().getRecordComponents())
                .map(component -> value(component, record))
                .flatMap(value -> value instanceof Record ? of((Record) value) : Stream.of(value));
    }

    private static Object value(RecordComponent component, Record record) {
        try {
            return opened(component.getAccessor()).invoke(record);
        } catch (ReflectiveOperationException cause) {
            throw new IllegalStateException(component + " cannot be read", cause);
        }
    }

    /** Makes the members of package-private records accessible. */
    private static <T extends AccessibleObject> T opened(T member) {
        member.setAccessible(true);
        return member;
    }

    /** A record as one line; its words must not contain tabs. */
    public static String line(Record record) {
        return of(record).map(Fields::word).collect(Collectors.joining(BETWEEN));
    }

    private static String word(Object value) {
        if (value instanceof Map) {
            return ((Map<?, ?>) value)
                    .entrySet().stream()
                            .map(one -> one.getKey() + AFTER_NAME + one.getValue())
                            .collect(Collectors.joining(BETWEEN_NAMED));
        }
        return value instanceof double[]
                ? DoubleStream.of((double[]) value)
                        .mapToObj(String::valueOf)
                        .collect(Collectors.joining(BETWEEN_NUMBERS))
                : String.valueOf(value);
    }

    /**
     * Parses a line of {@link #line}.
     *
     * @throws IllegalArgumentException when the line is cut short or of no such record
     */
    public static <R extends Record> R parse(Class<R> type, String line) {
        Iterator<String> words = List.of(line.split(BETWEEN, -1)).iterator();
        try {
            R record = read(type, words);
            if (!words.hasNext()) {
                return record;
            }
        } catch (NoSuchElementException | NumberFormatException wrong) {
            throw new IllegalArgumentException(notOne(type, line), wrong);
        }
        throw new IllegalArgumentException(notOne(type, line));
    }

    private static String notOne(Class<?> type, String line) {
        return "not a line of " + type.getSimpleName() + ": '" + line + "'";
    }

    private static <R> R read(Class<R> record, Iterator<String> words) {
        Class<?>[] types =
                Stream.of(record.getRecordComponents())
                        .map(RecordComponent::getType)
                        .toArray(Class<?>[]::new);
        Object[] values = new Object[types.length];
        for (int i = 0; i < types.length; i++) {
            values[i] = types[i].isRecord() ? read(types[i], words) : value(types[i], words.next());
        }
        try {
            Constructor<R> constructor = opened(record.getDeclaredConstructor(types));
            return constructor.newInstance(values);
        } catch (ReflectiveOperationException cause) {
            throw new IllegalStateException(record + " cannot be made", cause);
        }
    }

    private static Object value(Class<?> type, String word) {
        if (type.isEnum()) {
            return Stream.of(type.getEnumConstants())
                    .filter(constant -> ((Enum<?>) constant).name().equals(word))
                    .findFirst()
                    .orElseThrow();
        }
        return READERS.get(type).apply(word);
    }

    private static double[] numbers(String words) {
        return words.isEmpty()
                ? new double[0]
                : Arrays.stream(words.split(BETWEEN_NUMBERS))
                        .mapToDouble(Double::parseDouble)
                        .toArray();
    }

    private static Map<String, Double> named(String words) {
        Map<String, Double> numbers = new LinkedHashMap<>();
        if (!words.isEmpty()) {
            for (String one : words.split(BETWEEN_NAMED)) {
                int end = one.lastIndexOf(AFTER_NAME);
                numbers.put(one.substring(0, end), Double.valueOf(one.substring(end + 1)));
            }
        }
        return numbers;
    }
}

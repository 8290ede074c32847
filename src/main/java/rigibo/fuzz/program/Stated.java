package rigibo.fuzz.program;

import java.util.Arrays;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * A value and the Java that makes it. It is made anew each time it is asked for: making may be
 * refused.
 *
 * @param java an expression
 * @param making does what the expression says
 */
public record Stated<T>(String java, Supplier<T> making) {

    /** The value, or the exception that its maker throws. */
    public T value() {
        return making.get();
    }

    /** A call on the value. */
    <U> Stated<U> then(String call, Function<T, U> calling) {
        return new Stated<>(java + "." + call, () -> calling.apply(making.get()));
    }

    /** A call with numbers, or the numbers of a constructor. */
    static String call(String name, double... numbers) {
        return name + "(" + numbers(numbers) + ")";
    }

    /** Numbers as Java reads them, to the last bit. */
    static String numbers(double... numbers) {
        return Arrays.stream(numbers).mapToObj(Stated::number).collect(Collectors.joining(", "));
    }

    private static String number(double number) {
        if (Double.isNaN(number)) {
            return "Double.NaN";
        }
        if (Double.isInfinite(number)) {
            return number > 0 ? "Double.POSITIVE_INFINITY" : "Double.NEGATIVE_INFINITY";
        }
        return Double.toString(number);
    }

    /** A constant of an enum. */
    static String constant(Enum<?> value) {
        return value.getDeclaringClass().getSimpleName() + "." + value.name();
    }
}

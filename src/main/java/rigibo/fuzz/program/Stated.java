package rigibo.fuzz.program;

import java.util.Arrays;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * A value and the Java expression for it. The value is made anew each time, since making it may be
 * refused.
 *
 * @param java an expression
 * @param making does what the expression says
 */
public record Stated<T>(String java, Supplier<T> making) {

    /** The value; throws what its maker throws. */
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

    /** Numbers as Java literals, exact to the last bit. */
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

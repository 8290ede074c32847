package rigibo.backend.saved;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.Arrays;
import java.util.function.Function;

/**
 * How an immutable value is stated by numbers, and made of them again.
 *
 * @param name for messages
 * @param count how many numbers, or {@link #ANY}
 * @param numbers that state a value
 * @param maker of an equal value, to the last bit; refuses what states none with {@link
 *     IllegalArgumentException}
 */
record Form<T>(String name, int count, Function<T, double[]> numbers, Function<double[], T> maker) {

    /** A count that depends on the value. */
    static final int ANY = -1;

    /**
     * A disc is stated by its radius, a capsule by two numbers, a polygon by its corners and, where
     * it is rounded, one number more.
     */
    static final Form<Shape> SHAPE = new Form<>("shape", ANY, Form::numbersOf, Form::shapeOf);

    static final Form<Material> MATERIAL =
            new Form<>(
                    "material",
                    6,
                    m ->
                            new double[] {
                                m.density(),
                                m.friction(),
                                m.elasticity(),
                                m.rollingResistance(),
                                m.surfaceSpeed(),
                                m.drag()
                            },
                    n -> new Material(n[0], n[1], n[2], n[3], n[4], n[5]));

    private static final BodyType[] TYPES = BodyType.values();

    static final Form<BodyType> BODY_TYPE =
            new Form<>("body type", 1, t -> new double[] {t.ordinal()}, n -> typeOf(n[0]));

    private static BodyType typeOf(double number) {
        for (BodyType type : TYPES) {
            if (type.ordinal() == number) {
                return type;
            }
        }
        throw new IllegalArgumentException(
                "a body's type must be 0 to " + (TYPES.length - 1) + ", was " + number);
    }

    private static double[] numbersOf(Shape shape) {
        return switch (shape.kind()) {
            case CIRCLE -> new double[] {((Circle) shape).radius()};
            case CAPSULE ->
                    new double[] {((Capsule) shape).halfLength(), ((Capsule) shape).radius()};
            case POLYGON -> numbersOf((Polygon) shape);
        };
    }

    private static double[] numbersOf(Polygon polygon) {
        double[] corners = polygon.stated();
        if (polygon.radius() == 0) {
            return corners;
        }
        double[] numbers = Arrays.copyOf(corners, corners.length + 1);
        numbers[corners.length] = polygon.radius();
        return numbers;
    }

    private static Shape shapeOf(double[] numbers) {
        int corners = numbers.length / 2;
        return switch (numbers.length) {
            case 1 -> new Circle(numbers[0]);
            case 2 -> new Capsule(numbers[0], numbers[1]);
            default ->
                    numbers.length % 2 == 0
                            ? Polygon.of(numbers)
                            : Polygon.of(Arrays.copyOf(numbers, 2 * corners))
                                    .rounded(numbers[2 * corners]);
        };
    }
}

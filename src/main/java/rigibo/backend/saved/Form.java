package rigibo.backend.saved;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.DoubleStream;

/**
 * How an immutable value is converted to numbers, and made of them again.
 *
 * @param name for messages
 * @param count number of values, or {@link #ANY}
 * @param numbers converts a value to numbers
 * @param maker makes an equal value, to the last bit; rejects numbers that describe none with
 *     {@link IllegalArgumentException}
 */
record Form<T>(String name, int count, Function<T, double[]> numbers, Function<double[], T> maker) {

    /** A count that depends on the value. */
    static final int ANY = -1;

    /**
     * A disc is given by its radius, a capsule by two numbers, a polygon by its corners and, if
     * rounded, one number more. A compound begins with {@link #COMPOUND} and a chain with {@link
     * #CHAIN}; no other shape does.
     */
    static final Form<Shape> SHAPE = new Form<>("shape", ANY, Form::numbersOf, Form::shapeOf);

    private static final double COMPOUND = Double.POSITIVE_INFINITY;
    private static final double CHAIN = Double.NEGATIVE_INFINITY;

    /** Numbers of a chain before its first corner. */
    private static final int CHAIN_HEAD = 2;

    /** Numbers of a compound before its first part, and of a part before those of its shape. */
    private static final int COMPOUND_HEAD = 5;

    private static final int PART_HEAD = 6;

    static final Form<Material> MATERIAL =
            new Form<>(
                    "material",
                    8,
                    m ->
                            new double[] {
                                m.density(),
                                m.friction(),
                                m.elasticity(),
                                m.rollingResistance(),
                                m.surfaceSpeed(),
                                m.drag(),
                                m.oneWayX(),
                                m.oneWayY()
                            },
                    n -> new Material(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]));

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
            case COMPOUND -> numbersOf((Compound) shape);
            case CHAIN -> numbersOf((Chain) shape);
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

    /**
     * Number of parts, whether the centre was stated, the centre, then each part, preceded by the
     * number of its shape's values.
     */
    private static double[] numbersOf(Compound compound) {
        DoubleStream.Builder numbers = DoubleStream.builder();
        numbers.add(COMPOUND).add(compound.parts()).add(compound.statesCentre() ? 1 : 0);
        numbers.add(compound.centroidX()).add(compound.centroidY());
        for (int i = 0; i < compound.parts(); i++) {
            Part part = compound.part(i);
            double[] shape = numbersOf(part.shape());
            numbers.add(shape.length).add(part.x()).add(part.y());
            numbers.add(part.angle()).add(part.relativeDensity()).add(part.isSensor() ? 1 : 0);
            Arrays.stream(shape).forEach(numbers);
        }
        return numbers.build().toArray();
    }

    private static double[] numbersOf(Chain chain) {
        double[] numbers = new double[CHAIN_HEAD + 2 * chain.corners()];
        numbers[0] = CHAIN;
        numbers[1] = chain.isLoop() ? 1 : 0;
        for (int i = 0; i < chain.corners(); i++) {
            numbers[CHAIN_HEAD + 2 * i] = chain.cornerX(i);
            numbers[CHAIN_HEAD + 2 * i + 1] = chain.cornerY(i);
        }
        return numbers;
    }

    private static Chain chainOf(double[] numbers) {
        double[] xy = Arrays.copyOfRange(numbers, CHAIN_HEAD, numbers.length);
        return numbers[1] == 0 ? Chain.open(xy) : Chain.loop(xy);
    }

    private static Compound compoundOf(double[] numbers) {
        List<Part> parts = new ArrayList<>();
        int at = COMPOUND_HEAD;
        while (at + PART_HEAD <= numbers.length) {
            int from = at + PART_HEAD;
            int to = (int) Math.min(numbers.length, from + Math.max(0, numbers[at]));
            Shape shape = shapeOf(Arrays.copyOfRange(numbers, from, to));
            if (!(shape instanceof Convex convex)) {
                throw new IllegalArgumentException("a part of a compound must be convex");
            }
            Part part = numbers[at + 5] == 0 ? Part.of(convex) : Part.of(convex).sensor();
            parts.add(
                    part.at(numbers[at + 1], numbers[at + 2])
                            .angle(numbers[at + 3])
                            .relativeDensity(numbers[at + 4]));
            at = to;
        }
        if (at != numbers.length || parts.size() != numbers[1]) {
            throw new IllegalArgumentException("a compound's parts are cut short");
        }
        Compound compound = Compound.of(parts);
        return numbers[2] == 0 ? compound : compound.centredAt(numbers[3], numbers[4]);
    }

    private static Shape shapeOf(double[] numbers) {
        if (numbers.length >= COMPOUND_HEAD && numbers[0] == COMPOUND) {
            return compoundOf(numbers);
        }
        if (numbers.length >= CHAIN_HEAD && numbers[0] == CHAIN) {
            return chainOf(numbers);
        }
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

package rigibo.backend.law;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** The numbers of a scene, drawn from a seed. */
final class Draw {

    /** Spreads neighbouring seeds, whose first draws are alike: 2⁶⁴ over the golden ratio. */
    private static final long SPREAD = 0x9E3779B97F4A7C15L;

    private final Random random;

    Draw(long seed) {
        random = new Random(seed * SPREAD);
    }

    /** Evenly between two numbers. */
    double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    /** Between two positive numbers, every factor as likely as any other. */
    double ofAnySize(double least, double most) {
        return StrictMath.exp(between(StrictMath.log(least), StrictMath.log(most)));
    }

    /** A whole number from least to most. */
    int whole(int least, int most) {
        return least + random.nextInt(most - least + 1);
    }

    /** So many numbers from 0 to before the last, which need not differ. */
    List<Integer> steps(int count, int last) {
        return random.ints(count, 0, last).boxed().toList();
    }

    boolean chance(double probability) {
        return random.nextDouble() < probability;
    }

    <T> T oneOf(List<T> choices) {
        return choices.get(random.nextInt(choices.size()));
    }

    void shuffle(List<?> list) {
        Collections.shuffle(list, random);
    }

    /** A disc, box or regular polygon that a circle of the radius holds. */
    Shape shape(double radius) {
        return switch (random.nextInt(3)) {
            case 0 -> new Circle(radius);
            case 1 -> box(radius);
            default -> Polygon.regular(whole(3, 8), radius);
        };
    }

    /** A disc or a box that a circle of the radius holds. */
    Shape plainShape(double radius) {
        return chance(0.5) ? new Circle(radius) : box(radius);
    }

    private Polygon box(double radius) {
        double slope = between(0.2, 1.37);
        return Polygon.box(2 * radius * StrictMath.cos(slope), 2 * radius * StrictMath.sin(slope));
    }

    /** Friction from none to rubber's, elasticity from none to all, either end now and then. */
    Material material() {
        double friction = chance(0.2) ? 0 : between(0, 1.2);
        double elasticity = chance(0.2) ? whole(0, 1) : between(0, 1);
        return new Material(ofAnySize(0.2, 20), friction, elasticity);
    }

    /**
     * Places in a square lattice about the origin, shuffled, each up to a quarter of the clearance
     * off: circles of the radius about them do not meet.
     */
    List<double[]> places(int count, double radius, double clearance) {
        int side = (int) Math.ceil(Math.sqrt(count));
        double cell = 2 * radius + clearance;
        List<double[]> places = new ArrayList<>();
        for (int i = 0; i < side * side; i++) {
            double x = cell * (i % side - (side - 1) / 2.0);
            double y = cell * (i / side - (side - 1) / 2.0);
            double off = clearance / 4;
            places.add(new double[] {x + between(-off, off), y + between(-off, off)});
        }
        shuffle(places);
        return places.subList(0, count);
    }

    /** The body thrown at the origin from where it is, more or less, and spinning. */
    BodyDefinition thrownInwards(BodyDefinition body, double speed) {
        double distance = Math.max(1, Math.sqrt(body.x() * body.x() + body.y() * body.y()));
        double fast = speed * between(0.3, 1);
        return body.velocity(
                        -fast * body.x() / distance + between(-0.2, 0.2) * speed,
                        -fast * body.y() / distance + between(-0.2, 0.2) * speed)
                .spin(between(-2, 2) * speed);
    }
}

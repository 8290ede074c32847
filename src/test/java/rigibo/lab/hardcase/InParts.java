package rigibo.lab.hardcase;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.Arrays;

/**
 * Puts bodies together of parts whose outline is the one they had: a polygon of two halves, a disc
 * with a smaller one inside. Mass, inertia and centre are the same, so every truth is, too.
 */
final class InParts {

    /** Radius of the disc that lies inside of another, as a share of it. */
    private static final double INNER = 0.4;

    private InParts() {}

    /** A body that moves, in parts; others as they are. */
    static BodyDefinition of(BodyDefinition body) {
        return body.type() == BodyType.DYNAMIC ? body.shape(of(body.shape())) : body;
    }

    private static Shape of(Shape shape) {
        if (shape instanceof Circle) {
            return disc(((Circle) shape).radius());
        }
        boolean isSharp = shape instanceof Polygon && ((Polygon) shape).radius() == 0;
        return isSharp ? halves((Polygon) shape) : shape;
    }

    /** It lies off the centre, touches nothing, and weighs nothing. */
    private static Compound disc(double radius) {
        Circle inner = new Circle(INNER * radius);
        return Compound.of(
                Part.of(new Circle(radius)),
                Part.of(inner).at(INNER * radius, 0).relativeDensity(0));
    }

    /**
     * Cut across from the middle of its first side to that of the opposite one, or to the opposite
     * corner. What is named by a corner of the whole is so by one of a half.
     */
    private static Compound halves(Polygon whole) {
        int n = whole.corners();
        int opposite = n / 2;
        double[] first = new double[2 * n + 4];
        double[] second = new double[2 * n + 4];
        int a = putMiddle(whole, 0, first, 0);
        for (int i = 1; i <= opposite; i++) {
            a = put(whole.cornerX(i), whole.cornerY(i), first, a);
        }
        int b = 0;
        if (n % 2 == 0) {
            a = putMiddle(whole, opposite, first, a);
            b = putMiddle(whole, opposite, second, b);
        } else {
            a = put(whole.cornerX(opposite + 1), whole.cornerY(opposite + 1), first, a);
        }
        for (int i = opposite + 1; i <= n; i++) {
            b = put(whole.cornerX(i % n), whole.cornerY(i % n), second, b);
        }
        b = putMiddle(whole, 0, second, b);
        return Compound.of(part(Arrays.copyOf(first, a)), part(Arrays.copyOf(second, b)));
    }

    private static int put(double x, double y, double[] xy, int at) {
        xy[at] = x;
        xy[at + 1] = y;
        return at + 2;
    }

    private static int putMiddle(Polygon whole, int side, double[] xy, int at) {
        int next = (side + 1) % whole.corners();
        double x = (whole.cornerX(side) + whole.cornerX(next)) / 2;
        double y = (whole.cornerY(side) + whole.cornerY(next)) / 2;
        return put(x, y, xy, at);
    }

    private static Part part(double[] xy) {
        Polygon half = Polygon.of(xy);
        return Part.of(half).at(half.centroidX(), half.centroidY());
    }
}

package rigibo.lab.truth;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Bodies as most scenes have them, sizes in m, at the origin and at rest: of density 1. */
public final class Solid {

    private Solid() {}

    /** What they are of. */
    public static Material matter(double friction, double elasticity) {
        return new Material(1, friction, elasticity);
    }

    /** A body that moves, of any shape. */
    public static BodyDefinition of(Shape shape, double friction, double elasticity) {
        return BodyDefinition.dynamic(shape).material(matter(friction, elasticity));
    }

    /** A disc that moves. */
    public static BodyDefinition disc(double radius, double friction, double elasticity) {
        return of(new Circle(radius), friction, elasticity);
    }

    /** A disc that moves, of the usual material. */
    public static BodyDefinition disc(double radius) {
        return BodyDefinition.dynamic(new Circle(radius));
    }

    /** A box that moves. */
    public static BodyDefinition box(
            double width, double height, double friction, double elasticity) {
        return of(Polygon.box(width, height), friction, elasticity);
    }

    /** A box that moves, of the usual material. */
    public static BodyDefinition box(double width, double height) {
        return BodyDefinition.dynamic(Polygon.box(width, height));
    }

    /** A box that nothing moves. */
    public static BodyDefinition fixed(
            double width, double height, double friction, double elasticity) {
        return fixed(width, height).material(matter(friction, elasticity));
    }

    /** A box that nothing moves, of the usual material. */
    public static BodyDefinition fixed(double width, double height) {
        return BodyDefinition.fixed(Polygon.box(width, height));
    }

    /**
     * A pyramid on a floor at y = 0, storey by storey from the left.
     *
     * @param box of its boxes
     * @param base boxes of the lowest storey
     * @param side of a box, m
     * @param gap below each storey, m
     */
    public static Stream<BodyDefinition> pyramid(
            BodyDefinition box, int base, double side, double gap) {
        List<BodyDefinition> boxes = new ArrayList<>();
        for (int storey = 0; storey < base; storey++) {
            for (int i = 0; i < base - storey; i++) {
                double x = side * (i - (base - storey - 1) / 2.0);
                boxes.add(box.at(x, side * (storey + 0.5) + gap * (storey + 1)));
            }
        }
        return boxes.stream();
    }
}

package rigibo.lab.truth;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** The usual bodies of scenes, of density 1, at the origin and at rest; sizes in m. */
public final class Solid {

    private Solid() {}

    /** The material of the bodies. */
    public static Material matter(double friction, double elasticity) {
        return new Material(1, friction, elasticity);
    }

    /** A dynamic body of any shape. */
    public static BodyDefinition of(Shape shape, double friction, double elasticity) {
        return BodyDefinition.dynamic(shape).material(matter(friction, elasticity));
    }

    /** A dynamic disc. */
    public static BodyDefinition disc(double radius, double friction, double elasticity) {
        return of(new Circle(radius), friction, elasticity);
    }

    /** A dynamic disc of the usual material. */
    public static BodyDefinition disc(double radius) {
        return BodyDefinition.dynamic(new Circle(radius));
    }

    /** A dynamic box. */
    public static BodyDefinition box(
            double width, double height, double friction, double elasticity) {
        return of(Polygon.box(width, height), friction, elasticity);
    }

    /** A dynamic box of the usual material. */
    public static BodyDefinition box(double width, double height) {
        return BodyDefinition.dynamic(Polygon.box(width, height));
    }

    /** A fixed box. */
    public static BodyDefinition fixed(
            double width, double height, double friction, double elasticity) {
        return fixed(width, height).material(matter(friction, elasticity));
    }

    /** A fixed box of the usual material. */
    public static BodyDefinition fixed(double width, double height) {
        return BodyDefinition.fixed(Polygon.box(width, height));
    }

    /**
     * A pyramid on a floor at y = 0, storey by storey from the left.
     *
     * @param box the definition of a box
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

package rigibo.backend.geometry;

/**
 * A convex shape in one piece: a core of corners and a radius.
 *
 * <pre>{@code
 * Convex[] parts = {new Circle(0.5), new Capsule(0.3, 0.2), Polygon.box(1, 2)};
 * Compound body = Compound.of(Part.of(parts[0]), Part.of(parts[2]).at(0, 1.5));
 * }</pre>
 */
public sealed interface Convex extends Shape permits Circle, Capsule, Polygon {

    /** The outline that collision detection uses. */
    Outline outline();

    @Override
    default int parts() {
        return 1;
    }

    @Override
    default Outline outline(int part) {
        return outline();
    }
}

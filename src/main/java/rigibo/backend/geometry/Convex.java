package rigibo.backend.geometry;

/** A shape in one piece without a dent: a core of corners and a radius. */
public sealed interface Convex extends Shape permits Circle, Capsule, Polygon {

    /** The outline as collisions see it. */
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

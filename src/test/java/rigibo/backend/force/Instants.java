package rigibo.backend.force;

import rigibo.backend.geometry.Shape;

/** Bodies at an instant, for tests. */
final class Instants {

    private Instants() {}

    /** A body of that mass (kg) and inertia (kg·m²) at rest at the origin, turned by an angle. */
    static Instant of(Shape shape, double mass, double inertia, double angle) {
        Instant at = new Instant();
        at.shape = shape;
        at.mass = mass;
        at.inverseMass = 1 / mass;
        at.inverseInertia = 1 / inertia;
        at.boundingRadius = shape.boundingRadius();
        at.angle = angle;
        return at;
    }

    /** A body of 1 kg and 1 kg·m²: its accelerations are numerically forces and torques. */
    static Instant of(Shape shape, double angle) {
        return of(shape, 1, 1, angle);
    }
}

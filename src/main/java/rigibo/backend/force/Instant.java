package rigibo.backend.force;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Filter;
import rigibo.backend.storage.Bodies;

/**
 * A body at one instant: its properties, a state, and the accelerations that forces add there.
 * Mutable, so that its owner reuses it; the body need not ever reach that state.
 */
public final class Instant {

    /** The body's slot. */
    public int slot;

    public Shape shape;

    /**
     * Mass in kg, its inverse in 1/kg, inverse inertia in 1/(kg·m²) (0 if it does not turn),
     * bounding radius in m, and linear drag in 1/s.
     */
    public double mass;

    public double inverseMass;
    public double inverseInertia;
    public double boundingRadius;
    public double drag;

    /** Bits of the categories that the body belongs to. */
    public int category;

    /** Time, s since the pool was made. */
    public double time;

    /** Position in m, angle in rad, velocity in m/s and angular velocity in rad/s. */
    public double x;

    public double y;
    public double angle;
    public double velocityX;
    public double velocityY;
    public double spin;

    /** Results: acceleration in m/s² and angular acceleration in rad/s². */
    public double accelerationX;

    public double accelerationY;
    public double angularAcceleration;

    /** The angle whose cosine and sine were computed last; kept because many bodies do not turn. */
    private double knownAngle;

    private double knownCos = 1;
    private double knownSin;

    /** Takes the properties of a body. */
    public void take(Bodies bodies, int body) {
        slot = body;
        shape = bodies.shape[slot];
        mass = bodies.mass[slot];
        inverseMass = bodies.inverseMass[slot];
        inverseInertia = bodies.inverseInertiaOf(slot);
        boundingRadius = bodies.boundingRadius[slot];
        drag = bodies.drag == null ? 0 : bodies.drag[slot];
        category = bodies.category == null ? Filter.ALL.category() : bodies.category[slot];
    }

    /** Adds a force in N at the centre of mass. */
    public void push(double forceX, double forceY) {
        accelerationX += forceX * inverseMass;
        accelerationY += forceY * inverseMass;
    }

    /** Adds a torque in N·m, counter-clockwise. */
    public void turn(double torque) {
        angularAcceleration += torque * inverseInertia;
    }

    /** Cosine of the angle. */
    public double cos() {
        refreshAngle();
        return knownCos;
    }

    /** Sine of the angle. */
    public double sin() {
        refreshAngle();
        return knownSin;
    }

    private void refreshAngle() {
        if (angle != knownAngle) {
            knownAngle = angle;
            knownCos = Angle.cos(angle);
            knownSin = Angle.sin(angle);
        }
    }
}

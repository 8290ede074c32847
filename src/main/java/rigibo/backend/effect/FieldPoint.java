package rigibo.backend.effect;

/**
 * Input and output of a {@link FieldFunction}: the state of a body, and the acceleration added so
 * far. The object is reused for the next body.
 *
 * <pre>{@code
 * // Against motion, and up to a height of 3 m.
 * Field honey = new Field(at -> at.push(-at.velocityX, at.y < 3 ? 12 * at.mass : 0));
 * }</pre>
 */
public final class FieldPoint {

    /** World x of the centre of mass, m. */
    public double x;

    /** World y of the centre of mass, m, up. */
    public double y;

    /** Velocity of the centre of mass, m/s, to the right. */
    public double velocityX;

    /** Velocity of the centre of mass, m/s, up. */
    public double velocityY;

    /** Mass of the body, kg, positive. */
    public double mass;

    /** Simulated time since the pool was made, s. */
    public double time;

    /** Acceleration added so far, m/s², to the right. */
    public double accelerationX;

    /** Acceleration added so far, m/s², up. */
    public double accelerationY;

    /** Adds a force in N, to the right and up. */
    public void push(double forceX, double forceY) {
        accelerate(forceX / mass, forceY / mass);
    }

    /** Adds an acceleration in m/s², to the right and up, whatever the mass. */
    public void accelerate(double toTheRight, double up) {
        accelerationX += toTheRight;
        accelerationY += up;
    }
}

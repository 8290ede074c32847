package rigibo.backend.effect;

/**
 * What a {@link FieldFunction} is told of a body, and what it answers. A plain carrier that is used
 * again for the next body.
 *
 * <pre>{@code
 * // Against motion, and up to a height of 3 m.
 * Field honey = new Field(at -> at.push(-at.velocityX, at.y < 3 ? 12 * at.mass : 0));
 * }</pre>
 */
public final class FieldPoint {

    /** World place of the centre of mass, m, to the right. */
    public double x;

    /** World place of the centre of mass, m, up. */
    public double y;

    /** Velocity of the centre of mass, m/s, to the right. */
    public double velocityX;

    /** Velocity of the centre of mass, m/s, up. */
    public double velocityY;

    /** kg, positive. */
    public double mass;

    /** s since the pool was made. */
    public double time;

    /** What has been added so far, m/s², to the right. */
    public double accelerationX;

    /** What has been added so far, m/s², up. */
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

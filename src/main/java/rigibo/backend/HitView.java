package rigibo.backend;

/**
 * An impact of the last step as {@link Pool#forEachHit} passes it to its visitor. The pool
 * overwrites this one object for each impact: copy what must outlast the call, or keep {@link
 * #event}.
 *
 * <pre>{@code
 * double[] fastest = {0};
 * pool.forEachHit(hit -> fastest[0] = Math.max(fastest[0], hit.speed)); // no garbage
 * }</pre>
 */
public final class HitView {

    /** The body the normal points away from. */
    public RigidBody a;

    /** The body the normal points to. */
    public RigidBody b;

    /** Index of the part of a's shape that was hit, from 0; 0 for a shape in one piece. */
    public int partA;

    /** Index of the part of b's shape that was hit. */
    public int partB;

    /** World x of the midpoint of the contact, m. */
    public double x;

    /** World y of the midpoint of the contact, m, up. */
    public double y;

    /** Unit normal from a to b, world x. */
    public double normalX;

    /** Unit normal from a to b, world y. */
    public double normalY;

    /** Closing speed along the normal before the impact, at the fastest point, m/s, positive. */
    public double speed;

    /** Time of the impact since the start of the step, s. */
    public double time;

    HitView() {}

    /** A permanent copy. */
    public HitEvent event() {
        return new HitEvent(a, b, partA, partB, x, y, normalX, normalY, speed, time);
    }
}

package rigibo.backend;

/**
 * An impact of the last step as {@link Pool#forEachHit} shows it. It is one object that is written
 * anew for each impact: what must last beyond the visitor's call is copied, or kept as {@link
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

    /** Which part of a's shape was met, from 0; 0 of a shape in one piece. */
    public int partA;

    /** Which part of b's shape was met. */
    public int partB;

    /** World x of the middle of what met, m. */
    public double x;

    /** World y of the middle of what met, m, up. */
    public double y;

    /** Unit normal from a to b, world x. */
    public double normalX;

    /** Unit normal from a to b, world y. */
    public double normalY;

    /** At which the two came together along the normal, m/s, positive. */
    public double speed;

    /** When, s after the step began. */
    public double time;

    HitView() {}

    /** A copy that lasts. */
    public HitEvent event() {
        return new HitEvent(a, b, partA, partB, x, y, normalX, normalY, speed, time);
    }
}

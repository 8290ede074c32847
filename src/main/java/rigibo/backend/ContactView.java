package rigibo.backend;

import rigibo.backend.ContactEvent.Phase;

/**
 * A contact of the last step as {@link Pool#forEachContact} passes it to its visitor. The pool
 * overwrites this one object for each contact: copy what must outlast the call, or keep {@link
 * #event}.
 *
 * <pre>{@code
 * double[] hardest = {0};
 * pool.forEachContact(contact -> hardest[0] = Math.max(hardest[0], contact.impulse)); // no garbage
 * }</pre>
 */
public final class ContactView {

    /** The body the normal points away from. */
    public RigidBody a;

    /** The body the normal points to. */
    public RigidBody b;

    /** Index of the part of a's shape that touches, from 0; 0 for a shape in one piece. */
    public int partA;

    /** Index of the part of b's shape that touches. */
    public int partB;

    /** Whether the contact began, persisted or ended. */
    public Phase phase;

    /** World x of the contact's midpoint, m. */
    public double x;

    /** World y of the contact's midpoint, m, up. */
    public double y;

    /** Unit normal from a to b, world x. */
    public double normalX;

    /** Unit normal from a to b, world y. */
    public double normalY;

    /** Total normal impulse in the step, impacts included, N·s, 0 or more. */
    public double impulse;

    /**
     * Whether the bodies are forced into each other: they overlap by more than 5 % of the smaller
     * one's width.
     */
    public boolean isCrushing;

    /**
     * Number of contact points, 0 to 2, including points where the bodies nearly touch; 0 for a
     * contact that an edit ended.
     */
    public int points;

    /** World x of each point, m, midway between the two surfaces; not to be written. */
    public final double[] pointX = new double[2];

    /** World y of each point, m, up, midway between the two surfaces; not to be written. */
    public final double[] pointY = new double[2];

    /** Gap at each point when it was last measured, m; negative in overlap. */
    public final double[] separation = new double[2];

    /** Normal force at each point at the end of the step, N; 0 if the bodies only bounced. */
    public final double[] force = new double[2];

    /**
     * Friction force on b at the end of the step, N, positive along (−normalY, normalX); 0 where
     * {@code Friction} is not declared.
     */
    public double friction;

    ContactView() {}

    /** Whether both bodies are still in the pool. */
    public boolean bothAlive() {
        return a.isAlive() && b.isAlive();
    }

    /** A permanent copy; it lacks friction and the single points. */
    public ContactEvent event() {
        return new ContactEvent(
                a, b, partA, partB, phase, x, y, normalX, normalY, impulse, isCrushing);
    }

    void show(ContactEvent event) {
        points = 0;
        friction = 0;
        a = event.a();
        b = event.b();
        partA = event.partA();
        partB = event.partB();
        phase = event.phase();
        x = event.x();
        y = event.y();
        normalX = event.normalX();
        normalY = event.normalY();
        impulse = event.impulse();
        isCrushing = event.isCrushing();
    }
}

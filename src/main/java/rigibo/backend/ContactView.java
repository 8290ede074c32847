package rigibo.backend;

import rigibo.backend.ContactEvent.Phase;

/**
 * A contact of the last step as {@link Pool#forEachContact} shows it. It is one object that is
 * written anew for each contact: what must last beyond the visitor's call is copied, or kept as
 * {@link #event}.
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

    /** Which part of a's shape touches, from 0; 0 of a shape in one piece. */
    public int partA;

    /** Which part of b's shape touches. */
    public int partB;

    /** Whether the contact began, persisted or ended. */
    public Phase phase;

    /** World x of the contact's middle, m. */
    public double x;

    /** World y of the contact's middle, m, up. */
    public double y;

    /** Unit normal from a to b, world x. */
    public double normalX;

    /** Unit normal from a to b, world y. */
    public double normalY;

    /** Normal impulse of the step in N·s, impacts included, 0 or more. */
    public double impulse;

    /** Whether the two overlap deeper than 5 % of the smaller width, for something had to give. */
    public boolean isCrushing;

    /**
     * How many points the two touch or nearly touch in, 0 to 2; 0 of a contact that an edit ended.
     */
    public int points;

    /** World place of each point in m, midway between the two surfaces; read, not written. */
    public final double[] pointX = new double[2];

    public final double[] pointY = new double[2];

    /** Gap at each point as it was measured, m; negative in overlap. */
    public final double[] separation = new double[2];

    /** Normal force that each point carried as the step ended, N; 0 in a mere impact. */
    public final double[] force = new double[2];

    /**
     * Friction that the contact carried as the step ended, N on b along (−normalY, normalX); 0
     * where {@code Friction} is not declared.
     */
    public double friction;

    ContactView() {}

    /** Whether neither body was removed. */
    public boolean bothAlive() {
        return a.isAlive() && b.isAlive();
    }

    /** A copy that lasts, of all but the single points. */
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

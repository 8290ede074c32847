package rigibo.backend;

/**
 * A contact as it was in the last step; plain data, read after the step.
 *
 * <p>Two bodies, or two parts of them where one is a {@code Compound}, are told one {@code BEGIN},
 * a {@code PERSIST} for each further step in which they touch, asleep or not, and one {@code END}.
 * A contact may also end by an edit between two steps: a body was removed, placed anew or given
 * another shape or type, or {@code Contacts} are no longer declared. Then {@code END} comes with
 * the step after the edit, where the contact was, with an impulse of 0; two bodies that touch in
 * that step again {@code PERSIST}. A body that was removed is named all the same: see {@link
 * #bothAlive}. Only a restored pool, which has no handle on a body that was removed before its
 * snapshot, cannot tell what would name it.
 *
 * <pre>{@code
 * for (ContactEvent contact : pool.contactEvents()) {
 *     if (contact.phase() == ContactEvent.Phase.BEGIN && contact.impulse() > 5) { // N·s
 *         System.out.println(contact.a() + " hits " + contact.b());
 *     }
 * }
 * }</pre>
 *
 * @param a the body the normal points away from
 * @param b the body the normal points to
 * @param partA which part of a's shape touches, from 0; 0 of a shape in one piece
 * @param partB which part of b's shape touches
 * @param phase whether the contact began, persisted or ended
 * @param x world x of the contact's middle, m
 * @param y world y of the contact's middle, m
 * @param normalX unit normal from a to b
 * @param normalY unit normal from a to b
 * @param impulse normal impulse of the step in N·s, impacts included, 0 or more
 * @param isCrushing whether the two overlap deeper than 5 % of the smaller width, for something had
 *     to give
 */
public record ContactEvent(
        RigidBody a,
        RigidBody b,
        int partA,
        int partB,
        Phase phase,
        double x,
        double y,
        double normalX,
        double normalY,
        double impulse,
        boolean isCrushing) {

    /** Whether neither body was removed. */
    public boolean bothAlive() {
        return a.isAlive() && b.isAlive();
    }

    /** What became of the contact in the step. */
    public enum Phase {
        /** The bodies touch and did not in the step before; a bounce within one step begins too. */
        BEGIN,
        /** They touch and did in the step before, whatever happened to them in between. */
        PERSIST,
        /** They touched in the step before and do not any more, or one of them is gone. */
        END
    }
}

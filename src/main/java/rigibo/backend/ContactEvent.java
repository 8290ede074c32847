package rigibo.backend;

/**
 * A contact of the last step: plain data, read after the step.
 *
 * <p>When two bodies (or two parts, where one is a {@code Compound}) touch, the pool reports one
 * {@code BEGIN}, a {@code PERSIST} in each further step in which they touch, asleep or not, and one
 * {@code END}. An edit between steps can end a contact too: a body is removed, moved or given
 * another shape or type, or {@code Contacts} is no longer declared. The step after the edit then
 * reports {@code END} at the contact's old place with an impulse of 0, or {@code PERSIST} if the
 * bodies touch again in that step. A removed body is still named, see {@link #bothAlive}; only a
 * restored pool leaves out contacts with bodies removed before the snapshot, since it has no
 * handles on them.
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
 * @param partA index of the part of a's shape that touches, from 0; 0 for a shape in one piece
 * @param partB index of the part of b's shape that touches
 * @param phase whether the contact began, persisted or ended
 * @param x world x of the contact's midpoint, m
 * @param y world y of the contact's midpoint, m
 * @param normalX unit normal from a to b
 * @param normalY unit normal from a to b
 * @param impulse total normal impulse in the step, impacts included, N·s, 0 or more
 * @param isCrushing whether the bodies are forced into each other: they overlap by more than 5 % of
 *     the smaller one's width
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

    /** Whether both bodies are still in the pool. */
    public boolean bothAlive() {
        return a.isAlive() && b.isAlive();
    }

    /** What became of the contact in the step. */
    public enum Phase {
        /** The bodies touch, if only for a bounce, and did not touch in the step before. */
        BEGIN,
        /** They touch and touched in the step before, whatever edits came between. */
        PERSIST,
        /** They touched in the step before and no longer do, or one of them was removed. */
        END
    }
}

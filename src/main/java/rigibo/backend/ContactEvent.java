package rigibo.backend;

/**
 * A contact as it was in the last step; plain data, read after the step.
 *
 * @param a the body the normal points away from
 * @param b the body the normal points to
 * @param phase whether the contact began, persisted or ended
 * @param x world x of the contact's middle, m
 * @param y world y of the contact's middle, m
 * @param normalX unit normal from a to b
 * @param normalY unit normal from a to b
 * @param impulse normal impulse of the step in N·s, impacts included, 0 or more
 * @param isCrushing whether a kinematic body is pressed into the other deeper than 5 % of its width
 */
public record ContactEvent(
        RigidBody a,
        RigidBody b,
        Phase phase,
        double x,
        double y,
        double normalX,
        double normalY,
        double impulse,
        boolean isCrushing) {

    /** What became of the contact in the step. */
    public enum Phase {
        /** The bodies touch and did not before; a bounce within one step begins too. */
        BEGIN,
        /** They touch as before. */
        PERSIST,
        /** They touched before and do not any more. */
        END
    }
}

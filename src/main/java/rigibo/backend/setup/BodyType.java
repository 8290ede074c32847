package rigibo.backend.setup;

/**
 * How a body answers forces.
 *
 * <pre>{@code
 * crate.type(BodyType.STATIC); // from now on nothing moves it
 * }</pre>
 */
public enum BodyType {
    /** Moves under forces, contacts and impacts. */
    DYNAMIC,
    /** Never moves. */
    STATIC,
    /** Moves with exactly the velocity it was given; pushes others and is never pushed. */
    KINEMATIC
}

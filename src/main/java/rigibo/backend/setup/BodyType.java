package rigibo.backend.setup;

/**
 * How a body responds to forces and contacts.
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
    /** Moves with exactly the velocity it is given; pushes other bodies and is never pushed. */
    KINEMATIC
}

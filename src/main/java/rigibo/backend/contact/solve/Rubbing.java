package rigibo.backend.contact.solve;

/**
 * What surfaces do to each other along the tangent: nothing, friction, or friction and rolling
 * resistance, as declared.
 */
public interface Rubbing {

    /** Writes the rows of the packed island whose kicks begin with {@code firstKick} seconds. */
    void begin(double firstKick);

    /** Writes what follows from contacts that were measured anew. */
    void refresh();

    /** How many rows a pass solves. */
    int rowCount();

    /** Solves rolling and friction of a contact that rolls: only where it is declared does any. */
    default void roll(int row) {}

    /** Keeps what held in the last substep of h seconds. */
    void store(double h);
}

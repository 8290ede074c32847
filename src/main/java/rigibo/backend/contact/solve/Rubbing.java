package rigibo.backend.contact.solve;

/** The tangential rows of contacts, as declared: none, friction, rolling resistance, or both. */
public interface Rubbing {

    /** Writes the rows of the packed island, whose first kick has {@code firstKick} seconds. */
    void begin(double firstKick);

    /** Writes the rows again that depend on contacts which were measured again. */
    void refresh();

    /** Number of rows that a pass solves. */
    int rowCount();

    /** Solves rolling and friction of a contact; does nothing without rolling resistance. */
    default void roll(int row) {}

    /** Stores the forces of the last substep of h seconds. */
    void store(double h);
}

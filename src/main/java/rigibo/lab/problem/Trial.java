package rigibo.lab.problem;

/** A problem that is set and not yet run. */
@FunctionalInterface
public interface Trial {

    /** Steps all worlds to the end and says how far from the truth they went; once. */
    Errors run();
}

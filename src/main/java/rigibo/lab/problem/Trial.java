package rigibo.lab.problem;

/** A problem whose worlds are made and not yet stepped. */
@FunctionalInterface
public interface Trial {

    /** Steps all worlds to the end and returns their errors; called once. */
    Errors run();
}

package rigibo.lab.hardcase;

/** What a case simulates; the class that does derives the case's truth. */
@FunctionalInterface
public interface Scenes {

    /** Simulates every variant of the case and hands each figure to the trial. */
    void run(Trial trial);
}

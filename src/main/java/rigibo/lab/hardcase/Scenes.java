package rigibo.lab.hardcase;

/** The scenes of a case; the implementing class derives the case's truth. */
@FunctionalInterface
public interface Scenes {

    /** Simulates every variant of the case and records its figures in the trial. */
    void run(Trial trial);
}

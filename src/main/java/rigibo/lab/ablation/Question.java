package rigibo.lab.ablation;

import rigibo.lab.ablation.probe.Workload;
import rigibo.lab.ablation.probe.Workloads;

import java.nio.file.Path;
import java.util.List;

/**
 * The question that a report answers.
 *
 * @param scenes their names
 * @param runs pairs of each scene's comparison; costs have five at most
 * @param seed of the scenes' random numbers
 * @param out directory of everything written
 */
public record Question(List<String> scenes, int runs, long seed, Path out) {

    /** The largest number of runs; more would take days. */
    public static final int MOST_RUNS = 1000;

    /**
     * Checks names and numbers.
     *
     * @throws IllegalArgumentException naming what is wrong and what is allowed
     */
    public Question {
        List<String> known = sceneNames();
        for (String scene : scenes) {
            if (!known.contains(scene)) {
                throw new IllegalArgumentException(
                        "scenes: there is no scene '"
                                + scene
                                + "'; there are "
                                + String.join(", ", known));
            }
        }
        if (runs < 1 || runs > MOST_RUNS) {
            throw new IllegalArgumentException(
                    "runs: must be from 1 to " + MOST_RUNS + ", was " + runs);
        }
    }

    /** The names that may be asked for. */
    public static List<String> sceneNames() {
        return new Workloads(0).scenes().stream().map(Workload::name).toList();
    }
}

package rigibo.lab.bench.scene;

import java.util.function.Supplier;

/**
 * A named scene of the bench.
 *
 * @param name as it is asked for
 * @param what it is, in words
 * @param pace which of its steps are timed
 * @param scene of its bodies, laid out when they are needed
 */
public record BenchScene(String name, String what, Pace pace, Supplier<Scene> scene) {

    /** A copy with another number of timed steps. */
    public BenchScene timing(int steps) {
        return new BenchScene(name, what, pace.timing(steps), scene);
    }
}

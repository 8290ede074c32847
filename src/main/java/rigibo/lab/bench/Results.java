package rigibo.lab.bench;

import rigibo.lab.bench.probe.Sample;
import rigibo.lab.child.Interval;
import rigibo.lab.engine.RigiBoEngine;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/** The results of all rounds, by scene and engine. */
final class Results {

    private final List<Run> runs;

    Results(List<Run> runs) {
        this.runs = List.copyOf(runs);
    }

    List<Run> runs() {
        return runs;
    }

    /** The names of the engines that ran a scene. */
    List<String> engines(String scene) {
        return runs.stream()
                .filter(run -> run.scene().equals(scene))
                .map(Run::engine)
                .distinct()
                .toList();
    }

    /** The samples of an engine in a scene, one per round. */
    List<Sample> samples(String scene, String engine) {
        return runs.stream()
                .filter(run -> run.scene().equals(scene) && run.engine().equals(engine))
                .map(Run::sample)
                .toList();
    }

    /** The median over all rounds. */
    double median(String scene, String engine, ToDoubleFunction<Sample> of) {
        return Interval.of(samples(scene, engine).stream().mapToDouble(of).toArray()).median();
    }

    /**
     * The ratios of an engine's time to ours, each within one round, so that a slow spell of the
     * machine affects both. Empty if ours was not timed.
     */
    Optional<Interval> ratio(String scene, String engine) {
        List<Sample> ours = samples(scene, RigiBoEngine.NAME);
        List<Sample> theirs = samples(scene, engine);
        int rounds = Math.min(ours.size(), theirs.size());
        if (rounds == 0) {
            return Optional.empty();
        }
        double[] ratios = new double[rounds];
        for (int i = 0; i < rounds; i++) {
            ratios[i] = theirs.get(i).median() / ours.get(i).median();
        }
        return Optional.of(Interval.of(ratios));
    }
}

package rigibo.lab.bench;

import rigibo.lab.bench.probe.Sample;
import rigibo.lab.child.Interval;
import rigibo.lab.engine.RigiBoEngine;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/** What was found, by scene and engine, over all rounds. */
final class Results {

    private final List<Run> runs;

    Results(List<Run> runs) {
        this.runs = List.copyOf(runs);
    }

    List<Run> runs() {
        return runs;
    }

    /** Names of the engines that a scene was timed with. */
    List<String> engines(String scene) {
        return runs.stream()
                .filter(run -> run.scene().equals(scene))
                .map(Run::engine)
                .distinct()
                .toList();
    }

    /** What an engine made of a scene, a sample each round. */
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
     * Times of an engine in times of ours, of the same round each: what slows the machine down for
     * a while slows down both. Empty where ours was not timed.
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

package rigibo.lab.hardcase;

import rigibo.lab.bench.scene.Scene;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * A column collapses, a heap spreads, boxes slide down a slope of boxes in a drum. These scenes are
 * chaotic, so that single runs have no truth. Truth: the mean over seeds, taken from EXACT at a
 * sixteenth of the step. An engine that calms bodies by damping or clamps spreads them less far and
 * leaves steeper slopes.
 */
record CalmWithoutDamping(Avalanche avalanche) implements Scenes {

    private static final int REFERENCE_PARTS = 16;
    private static final double HORIZON = 6;
    private static final Limits MOST_OFF = Limits.same(0.03);

    @Override
    public void run(Trial trial) {
        int seeds = trial.sampling().count(3, 20);
        int boxes = trial.sampling().count(25, 100);
        List<MeansOfRuns> runs = new ArrayList<>();
        List<MeansOfRuns> truths = new ArrayList<>();
        for (int i = 0; i < seeds; i++) {
            Scene scene = avalanche.scene(boxes, trial.sampling().random(i).nextLong());
            MeansOfRuns run = MeansOfRuns.of(scene, trial.preset().accuracy(), 1, HORIZON);
            trial.fold(run.hashCode());
            runs.add(run);
            truths.add(MeansOfRuns.of(scene, Preset.EXACT.accuracy(), REFERENCE_PARTS, HORIZON));
        }
        trial.variant(seeds + " seeds, " + boxes + " boxes");
        compare(trial, "energy of motion", runs, truths, MeansOfRuns::energy);
        if (avalanche == Avalanche.DRUM) {
            compare(trial, "slope", runs, truths, MeansOfRuns::slope);
        } else {
            compare(trial, "run-out", runs, truths, MeansOfRuns::spread);
            compare(trial, "height", runs, truths, MeansOfRuns::height);
        }
    }

    /** Compares two means; reports the standard error of their difference, too. */
    private static void compare(
            Trial trial,
            String name,
            List<MeansOfRuns> runs,
            List<MeansOfRuns> truths,
            ToDoubleFunction<MeansOfRuns> of) {
        double truth = truths.stream().mapToDouble(of).average().orElseThrow();
        int count = runs.size();
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < count; i++) {
            double off = of.applyAsDouble(runs.get(i)) - of.applyAsDouble(truths.get(i));
            sum += off / truth;
            squares += off * off / (truth * truth);
        }
        double mean = sum / count;
        double error = Math.sqrt(Math.max(0, squares / count - mean * mean) / (count - 1));
        trial.measure(name + " off", Math.abs(mean), "of truth", MOST_OFF);
        trial.measure(name + ", standard error", error, "of truth", Limits.NONE);
    }
}

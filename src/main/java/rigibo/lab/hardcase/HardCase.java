package rigibo.lab.hardcase;

import rigibo.backend.setup.BodyDefinition;

import java.util.Comparator;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/**
 * A scene that is hard to simulate and whose truth is known.
 *
 * @param row the case's number in the catalogue of hard cases
 * @param title what is true of the scene, as a sentence
 * @param fastest the fastest preset that the case is counted for
 * @param limitedFrom the fastest preset that is held to the limit of a game; those below it only
 *     report the case's own figures, and are held to what is true in every case as well
 * @param finding why the case does not reach its truth everywhere, as far as it is known, or empty
 * @param scenes what is simulated
 */
public record HardCase(
        String row,
        String title,
        Preset fastest,
        Preset limitedFrom,
        String finding,
        Scenes scenes) {

    /** A case that is counted, and held to its limits, at every preset. */
    static HardCase of(String row, String title, Scenes scenes) {
        return new HardCase(row, title, Preset.DRAFT, Preset.DRAFT, "", scenes);
    }

    HardCase fastest(Preset preset) {
        return new HardCase(row, title, preset, limitedFrom, finding, scenes);
    }

    HardCase limitedFrom(Preset preset) {
        return new HardCase(row, title, fastest, preset, finding, scenes);
    }

    HardCase finding(String words) {
        return new HardCase(row, title, fastest, limitedFrom, words, scenes);
    }

    /** Runs a few variants of the case. */
    public Result run(Preset preset) {
        return run(preset, Sampling.USUAL);
    }

    /** Runs the case twice: the second run, by several workers, must end in the same bits. */
    public Result run(Preset preset, Sampling sampling) {
        Trial first = trial(preset, sampling, UnaryOperator.identity(), 1);
        first.compare(trial(preset, sampling, UnaryOperator.identity(), Trial.SEVERAL));
        return new Result(this, preset, first.measures(), first.work());
    }

    /** Runs a few variants of the case once. */
    public Result runOnce(Preset preset) {
        return runOnce(preset, UnaryOperator.identity());
    }

    /** Runs a few variants of the case once, with other bodies in the place of the case's. */
    Result runOnce(Preset preset, UnaryOperator<BodyDefinition> made) {
        Trial trial = trial(preset, Sampling.USUAL, made, 1);
        return new Result(this, preset, trial.measures(), trial.work());
    }

    /**
     * Runs a few variants of the case once; returns a hash of the states that they go through,
     * which is the same wherever they run.
     */
    public long states(Preset preset) {
        return trial(preset, Sampling.USUAL, UnaryOperator.identity(), 1).hash();
    }

    private Trial trial(
            Preset preset, Sampling sampling, UnaryOperator<BodyDefinition> made, int workers) {
        Trial trial = new Trial(preset, limitedFrom, sampling, made, workers);
        scenes.run(trial);
        return trial;
    }

    /** The result of a run that broke off. */
    public Result broken(Preset preset, Throwable cause) {
        Measure end = new Measure("runs that broke off", 1, 0, "runs", cause.toString());
        return new Result(this, preset, List.of(end), CaseWork.NONE);
    }

    /**
     * The result of a case at a preset.
     *
     * @param hardCase the case
     * @param preset how exactly it was run
     * @param measures the case's own first, then the invariants
     * @param work what the first of the two runs cost
     */
    public record Result(HardCase hardCase, Preset preset, List<Measure> measures, CaseWork work) {

        public boolean passes() {
            return measures.stream().allMatch(Measure::passes);
        }

        /** The figure nearest to its limit, or farthest beyond it. */
        public Measure worst() {
            return measures.stream()
                    .min(
                            Comparator.comparing(Measure::isReported)
                                    .thenComparingDouble(Measure::margin))
                    .orElseThrow();
        }

        @Override
        public String toString() {
            return hardCase.row()
                    + " "
                    + preset
                    + ": "
                    + hardCase.title()
                    + measures.stream()
                            .map(measure -> "\n  " + measure)
                            .collect(Collectors.joining())
                    + "\n  work: "
                    + work;
        }
    }
}

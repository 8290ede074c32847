package rigibo.lab.ablation;

import rigibo.lab.ablation.probe.Sample;
import rigibo.lab.ablation.probe.Share;
import rigibo.lab.child.Interval;

import java.util.List;
import java.util.stream.Stream;

/**
 * The findings of all runs.
 *
 * @param ablations of every scene
 * @param uses of every effect, by how many use it
 * @param savings of every scene, by what is left out
 */
record Findings(List<Ablation> ablations, List<UseCost> uses, List<Saving> savings) {

    /** The distance from 1 within which a ratio counts as equal. */
    static final double TOLERANCE = 0.01;

    /** The least coverage of a meaningful interval; that of five values covers 0.9375. */
    static final double LEAST_COVERAGE = 0.93;

    /** The verdict on an interval of ratios. */
    enum Verdict {
        EQUAL("equal within 1 %"),
        NOT_TOLD_APART("not told apart"),
        DIFFERENT("different"),
        TOO_FEW_RUNS("too few runs to tell");

        private final String words;

        Verdict(String words) {
            this.words = words;
        }

        @Override
        public String toString() {
            return words;
        }
    }

    /**
     * The comparison of a scene with and without the classes of undeclared effects in the archive.
     *
     * @param scene its name
     * @param words what it is
     * @param period steps until its bodies are put back
     * @param takenOut how many class files were taken out
     * @param pairs stripped first, full second
     */
    record Ablation(String scene, String words, int period, int takenOut, Pairs pairs) {

        /** Whether a cost of undeclared effects is excluded, visible, or neither. */
        Verdict verdict() {
            Interval ratio = pairs.ratio();
            if (ratio.coverage() < LEAST_COVERAGE) {
                return Verdict.TOO_FEW_RUNS;
            }
            if (ratio.isWithin(TOLERANCE, 1)) {
                return Verdict.EQUAL;
            }
            return ratio.contains(1) ? Verdict.NOT_TOLD_APART : Verdict.DIFFERENT;
        }

        /** Whether bits and work are the same in every run. */
        boolean isSame() {
            return pairs.haveEqualBits() && pairs.haveEqualWork();
        }

        /** The sample of any of its runs. */
        Sample sample() {
            return pairs.second().get(0);
        }
    }

    /**
     * The cost of a declared effect that a number of bodies use.
     *
     * @param effect its simple name
     * @param scene the scene's name
     * @param sceneWords what the scene is
     * @param words how a body uses it
     * @param users how many do
     * @param pairs undeclared first, declared second
     */
    record UseCost(
            String effect,
            String scene,
            String sceneWords,
            String words,
            Share share,
            int users,
            Pairs pairs) {}

    /**
     * The time that a scene saves without an effect.
     *
     * @param companions effects left out with it, because they need it
     * @param pairs without it first, whole second
     */
    record Saving(String scene, String effect, List<String> companions, Pairs pairs) {

        /** The saving per step, in % of the whole scene's time. */
        Interval percent() {
            return pairs.times((without, whole) -> 100 * (whole - without) / whole);
        }
    }

    /** The names of the effects whose use was measured, in their order. */
    List<String> effects() {
        return uses.stream().map(UseCost::effect).distinct().toList();
    }

    /** The costs of an effect, by rising shares of users. */
    List<UseCost> usesOf(String effect) {
        return uses.stream().filter(use -> use.effect().equals(effect)).toList();
    }

    /** A scene's savings. */
    Stream<Saving> savingsOf(String scene) {
        return savings.stream().filter(saving -> saving.scene().equals(scene));
    }
}

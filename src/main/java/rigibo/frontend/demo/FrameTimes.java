package rigibo.frontend.demo;

import rigibo.backend.StepReport;
import rigibo.backend.setup.StepStage;
import rigibo.frontend.scene.accuracy.StageProfile;

import java.util.Arrays;

/**
 * Times of the steps and of the drawing in the last two seconds, and whether both fit into 60 Hz.
 */
final class FrameTimes {

    static final double BUDGET_MILLIS = StageProfile.BUDGET_MILLIS;

    private static final int WINDOW = 120;

    /** Number of frames in a hundred that must be in time for a rate to count as held. */
    private static final int HELD = 95;

    /** Fewest steps that give figures, so that a single late one does not decide them. */
    private static final int MEASURED = 30;

    /** Least share that one load is of another if times are to be compared. */
    private static final double ALIKE = 0.8;

    private final double[] steps = new double[WINDOW];
    private final double[] frames = new double[WINDOW];

    /** Contacts solved by each step: its work by a count that no clock and no worker changes. */
    private final double[] solves = new double[WINDOW];

    private int turn;
    private double drawing;

    /** Records the times of a step. */
    void step(StepReport report) {
        long nanos = 0;
        for (StepStage stage : StepStage.values()) {
            nanos += report.nanos(stage);
        }
        steps[turn % WINDOW] = nanos / 1e6;
        frames[turn % WINDOW] = nanos / 1e6 + drawing;
        solves[turn % WINDOW] = report.contactSolves();
        turn++;
    }

    /** Records the time that drawing took, ns. */
    void drawing(long nanos) {
        drawing = nanos / 1e6;
    }

    /** Begins anew. */
    void forget() {
        turn = 0;
    }

    /** The time below which a percentage of the steps stay, ms. */
    double step(int percent) {
        return percentile(steps, percent);
    }

    /** Whether there were enough steps to tell figures of them. */
    boolean isMeasured() {
        return turn >= MEASURED;
    }

    /** Whether steps had about as much work as others. */
    boolean isAsLoadedAs(FrameTimes others) {
        double here = percentile(solves, 50);
        double there = others.percentile(others.solves, 50);
        return Math.min(here, there) >= ALIKE * Math.max(here, there);
    }

    /** Whether the steps alone hold 60 Hz. */
    boolean stepHolds() {
        return percentile(steps, HELD) <= BUDGET_MILLIS;
    }

    /** Whether steps and drawing together hold 60 Hz. */
    boolean frameHolds() {
        return percentile(frames, HELD) <= BUDGET_MILLIS;
    }

    private double percentile(double[] millis, int percent) {
        double[] sorted = Arrays.copyOf(millis, Math.max(1, Math.min(turn, WINDOW)));
        Arrays.sort(sorted);
        return sorted[(sorted.length - 1) * percent / 100];
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.StepReport;
import rigibo.lab.child.Work;

import java.util.Locale;

/**
 * What the steps of a case cost, in counts that are the same on every machine.
 *
 * @param steps made
 * @param all work of all steps
 * @param mostImpacts most impacts in one step
 */
public record CaseWork(long steps, Work all, int mostImpacts) {

    /** The work of no steps. */
    static final CaseWork NONE = new CaseWork(0, Work.NONE, 0);

    /** This and a step more. */
    CaseWork plus(StepReport step) {
        int most = Math.max(mostImpacts, step.impacts());
        return new CaseWork(steps + 1, all.plus(Work.of(step)), most);
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "steps %d, pairs %d, impacts %d (at most %d in a step), evaluations %d, rows %d",
                steps,
                all.pairs(),
                all.impacts(),
                mostImpacts,
                all.evaluations(),
                all.rows());
    }
}

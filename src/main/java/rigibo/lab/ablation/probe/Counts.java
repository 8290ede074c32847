package rigibo.lab.ablation.probe;

import rigibo.backend.StepReport;

/**
 * What steps did, in counts that are the same on every machine; each the sum over all steps.
 *
 * @param pairs candidate pairs
 * @param contacts pairs that touched
 * @param impacts resolved at their own time
 * @param evaluations of a distance, in the search for times of impact
 * @param rows of the contact solver
 */
public record Counts(long pairs, long contacts, long impacts, long evaluations, long rows) {

    /** Of no step. */
    static final Counts NONE = new Counts(0, 0, 0, 0, 0);

    Counts plus(StepReport report) {
        return new Counts(
                pairs + report.pairs(),
                contacts + report.contacts(),
                impacts + report.impacts(),
                evaluations + report.evaluations(),
                rows + report.rows());
    }

    /** Solver rows per touching pair; 0 where nothing touched. */
    public double rowsPerContact() {
        return contacts == 0 ? 0 : (double) rows / contacts;
    }
}

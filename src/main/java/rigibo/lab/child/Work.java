package rigibo.lab.child;

import rigibo.backend.StepReport;

/**
 * Counts of the work of steps, which are the same on every machine.
 *
 * @param pairs candidate pairs
 * @param contacts pairs that touched
 * @param impacts resolved
 * @param evaluations of a separation while times of impact were searched
 * @param rows of contacts that solvers were given
 */
public record Work(long pairs, long contacts, long impacts, long evaluations, long rows) {

    /** No work, or work that an engine does not report. */
    public static final Work NONE = new Work(0, 0, 0, 0, 0);

    /** The work of a step of our engine. */
    public static Work of(StepReport report) {
        return new Work(
                report.pairs(),
                report.contacts(),
                report.impacts(),
                report.evaluations(),
                report.rows());
    }

    /** The sum of rows, evaluations and impacts. */
    public long solved() {
        return rows + evaluations + impacts;
    }

    /** The sum of this work and more. */
    public Work plus(Work more) {
        return new Work(
                pairs + more.pairs,
                contacts + more.contacts,
                impacts + more.impacts,
                evaluations + more.evaluations,
                rows + more.rows);
    }
}

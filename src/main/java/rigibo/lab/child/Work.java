package rigibo.lab.child;

import rigibo.backend.StepReport;

/**
 * Work that was done, counted: the same on every machine, whatever its clock says.
 *
 * @param pairs candidate pairs
 * @param contacts pairs that touched
 * @param impacts resolved
 * @param evaluations of a separation while times of impact were searched
 * @param rows of contacts that solvers were given
 */
public record Work(long pairs, long contacts, long impacts, long evaluations, long rows) {

    /** None, or none that is told. */
    public static final Work NONE = new Work(0, 0, 0, 0, 0);

    /** What a step of ours did. */
    public static Work of(StepReport report) {
        return new Work(
                report.pairs(),
                report.contacts(),
                report.impacts(),
                report.evaluations(),
                report.rows());
    }

    /** What is solved for: rows, evaluations and impacts together. */
    public long solved() {
        return rows + evaluations + impacts;
    }

    /** This and more. */
    public Work plus(Work more) {
        return new Work(
                pairs + more.pairs,
                contacts + more.contacts,
                impacts + more.impacts,
                evaluations + more.evaluations,
                rows + more.rows);
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.StepReport;

/** What the steps of a case cost, in counts that are the same on every machine. */
public final class Work {

    private long steps;
    private long pairs;
    private long impacts;
    private long evaluations;
    private long rows;
    private int mostImpacts;

    void add(StepReport report) {
        steps++;
        pairs += report.pairs();
        impacts += report.impacts();
        evaluations += report.evaluations();
        rows += report.rows();
        mostImpacts = Math.max(mostImpacts, report.impacts());
    }

    public long steps() {
        return steps;
    }

    /** Candidate pairs, summed over all steps. */
    public long pairs() {
        return pairs;
    }

    /** Impacts resolved at their own time. */
    public long impacts() {
        return impacts;
    }

    /** Evaluations of a distance in the search for times of impact. */
    public long evaluations() {
        return evaluations;
    }

    /** Solver rows, summed over all steps. */
    public long rows() {
        return rows;
    }

    /** Most impacts in one step. */
    public int mostImpacts() {
        return mostImpacts;
    }

    @Override
    public String toString() {
        return "steps "
                + steps
                + ", pairs "
                + pairs
                + ", impacts "
                + impacts
                + " (at most "
                + mostImpacts
                + " in a step), evaluations "
                + evaluations
                + ", rows "
                + rows;
    }
}

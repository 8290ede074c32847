package rigibo.lab.hardcase;

import rigibo.backend.StepReport;

/**
 * What a step cost, in counts.
 *
 * @param work rows, evaluations of a distance and impacts
 * @param contacts pairs that touched
 */
record Costs(double work, double contacts) {

    static Costs of(StepReport report) {
        double work = report.rows() + report.evaluations() + report.impacts();
        return new Costs(work, report.contacts());
    }

    Costs plus(Costs other) {
        return new Costs(work + other.work, contacts + other.contacts);
    }
}

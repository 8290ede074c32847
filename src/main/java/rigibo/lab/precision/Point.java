package rigibo.lab.precision;

import rigibo.lab.child.Work;
import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Timing;
import rigibo.lab.problem.Errors;

import java.util.Optional;

/**
 * The result of one engine at one setting and one problem.
 *
 * @param problem id
 * @param engine name
 * @param setting its name
 * @param errors errors of the run, or why it failed
 * @param steps number of steps, of all worlds together
 * @param work counted work of these steps
 * @param timing times of the steps; empty if they were not measured
 */
record Point(
        String problem,
        String engine,
        Setting setting,
        Errors errors,
        long steps,
        Work work,
        Optional<Timing> timing) {

    /** The simulated time of all worlds together, s. */
    double simulated() {
        return steps * setting.step();
    }

    /** The processor time per simulated second, s; NaN if it was not measured. */
    double cost() {
        return timing.map(took -> took.cpu() * 1e-6 / setting.step()).orElse(Double.NaN);
    }
}

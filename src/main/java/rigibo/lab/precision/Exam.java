package rigibo.lab.precision;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Patience;

import java.util.List;

/**
 * The settings of an engine that one process runs at one problem.
 *
 * @param problem id
 * @param engine name
 * @param settings to run, in the order of the report
 * @param patience the time for all of them
 */
record Exam(String problem, Engine engine, List<Setting> settings, Patience patience) {

    /** The settings that are measured: one of each group of aliases. */
    List<Setting> measured() {
        return settings.stream().map(engine::standsFor).distinct().toList();
    }
}

package rigibo.lab.precision;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Patience;

import java.util.List;

/**
 * An engine that is put to a problem, all of it in one process.
 *
 * @param problem id
 * @param engine that is asked
 * @param settings at which it is, in the order they are told
 * @param patience with all of them
 */
record Exam(String problem, Engine engine, List<Setting> settings, Patience patience) {

    /** Those that take turns: of settings that are the same under several names, one. */
    List<Setting> measured() {
        return settings.stream().map(engine::standsFor).distinct().toList();
    }
}

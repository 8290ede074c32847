package rigibo.lab.precision;

import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Patience;

import java.util.List;

/**
 * One process that is to be run.
 *
 * @param problem id
 * @param engine name
 * @param settings asked one after the other
 * @param patience with each of them
 */
record Task(String problem, String engine, List<Setting> settings, Patience patience) {

    /** The names of its settings. */
    List<String> names() {
        return settings.stream().map(Setting::name).toList();
    }
}

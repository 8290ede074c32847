package rigibo.lab.engine;

import rigibo.backend.effect.Effects;

import java.util.List;
import java.util.Optional;

/**
 * A physics engine that the laboratory examines. Engines other than ours are found on the class
 * path by {@code ServiceLoader}.
 */
public interface Engine {

    /**
     * A sentence that says why the engine cannot run on this machine; empty if it can. No other
     * method is called on an engine that cannot run.
     */
    default Optional<String> missing() {
        return Optional.empty();
    }

    /** Its name and version, as its authors write them. */
    String name();

    /** Its settings, the default one first. Their names are unique within the engine. */
    List<Setting> settings();

    /**
     * The setting that a setting is an alias of, so that results of one hold for both; the setting
     * itself if it is no alias.
     */
    default Setting standsFor(Setting setting) {
        return setting;
    }

    /**
     * A world without bodies.
     *
     * @throws UnsupportedOperationException naming an effect that the engine has not, and that no
     *     user of it could add with a few lines around a step
     */
    World world(Effects effects, Setting setting);
}

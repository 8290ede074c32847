package rigibo.lab.engine;

import rigibo.backend.effect.Effects;

import java.util.List;
import java.util.Optional;

/**
 * A physics engine that the laboratory puts its problems to. Those that are not ours are found by
 * {@code ServiceLoader}, where the class path holds them.
 */
public interface Engine {

    /**
     * Why it cannot run on this machine, as a sentence for who measures; empty where it can. One
     * that cannot is asked for nothing else.
     */
    default Optional<String> missing() {
        return Optional.empty();
    }

    /** Its name and version, as its authors write them. */
    String name();

    /** How it is run: first as it comes, then otherwise. Names are its own and differ. */
    List<Setting> settings();

    /**
     * The setting that one of its settings is another name of, so that what was found for it holds
     * for both; the setting itself where it is no other's.
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

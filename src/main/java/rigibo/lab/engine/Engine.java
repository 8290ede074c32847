package rigibo.lab.engine;

import rigibo.backend.effect.Effects;

import java.util.List;

/**
 * A physics engine that the laboratory puts its problems to. Those that are not ours are found by
 * {@code ServiceLoader}, where the class path holds them.
 */
public interface Engine {

    /** Its name and version, as its authors write them. */
    String name();

    /** How it is run: first as it comes, then otherwise. Names are its own and differ. */
    List<Setting> settings();

    /**
     * A world without bodies.
     *
     * @throws UnsupportedOperationException naming an effect that the engine has not, and that no
     *     user of it could add with a few lines around a step
     */
    World world(Effects effects, Setting setting);
}

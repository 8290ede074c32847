package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;

import java.util.function.Consumer;

/**
 * A case of joints: as a rule DRAFT is held to what is true in every case alone.
 *
 * @param row of the catalogue
 * @param title what is true of it, as a sentence
 * @param limitedFrom the fastest preset that is held to the case's own limits
 * @param scenes simulates every variant
 * @param finding why it does not reach its truth everywhere, or empty
 */
record JointCase(
        String row, String title, Preset limitedFrom, Consumer<Trial> scenes, String finding)
        implements HardCase {

    /** Most that what a joint holds may be off, m. */
    static final Limits ERROR = Limits.of(1e-4, 1e-9);

    /** Most that a place of closed form may be off, as a share of the scene's extent. */
    static final Limits PLACE = Limits.of(1e-3, 1e-6);

    /** Most that a force of statics may be off, as a share of it. */
    static final Limits FORCE = Limits.of(1e-2, 1e-4);

    private static final Effects EARTH = Surroundings.earth().with(new Joints());
    private static final Effects SPACE = EARTH.without(Gravity.class);

    JointCase(String row, String title, Consumer<Trial> scenes) {
        this(row, title, Preset.GAME, scenes, "");
    }

    @Override
    public void run(Trial trial) {
        scenes.accept(trial);
    }

    /** A pool with weight. */
    static WatchedPool earth(Trial trial) {
        return trial.pool(EARTH);
    }

    /** A pool without weight. */
    static WatchedPool space(Trial trial) {
        return trial.pool(SPACE);
    }

    /** Something fixed to hang other things on, which meets nobody. */
    static RigidBody hook(WatchedPool pool, double x, double y) {
        return pool.add(BodyDefinition.fixed(new Circle(0.01)).at(x, y).filter(Filter.ALL.mask(0)));
    }

    /** Keeps by how much all joints of a pool are off now. */
    static void measureErrors(Trial trial, WatchedPool pool) {
        trial.measure("error of joints", pool.jointError(), "m", ERROR);
    }
}

package rigibo.lab.bench.probe;

import rigibo.lab.bench.scene.Scene;
import rigibo.lab.child.Work;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;

/** A scene in a world of some engine. */
public final class Stage implements AutoCloseable {

    private final Scene scene;
    private final World world;
    private int made;

    /** A world with all bodies of a scene. */
    public Stage(Engine engine, Setting setting, Scene scene) {
        this.scene = scene;
        world = engine.world(scene.effects(), setting);
        scene.build(world);
    }

    /** Where to look at what became of the bodies; its steps are made here alone. */
    public World world() {
        return world;
    }

    /** Moves what is driven: not part of what is timed, for it is ours and not the engine's. */
    public void drive() {
        scene.driver().drive(world, made);
    }

    /**
     * The step alone, after {@link #drive}; and what a loss costs, for it wakes who leaned on it.
     */
    public void step() {
        scene.loss().befall(world, made);
        world.step(Scene.STEP);
        made++;
    }

    public Work lastStep() {
        return world.lastStep();
    }

    @Override
    public void close() {
        world.close();
    }
}

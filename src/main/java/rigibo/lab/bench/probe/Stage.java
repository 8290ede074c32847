package rigibo.lab.bench.probe;

import rigibo.lab.bench.scene.Scene;
import rigibo.lab.child.Work;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;

/** A scene in a world of an engine. */
public final class Stage implements AutoCloseable {

    private final Scene scene;
    private final World world;
    private int made;

    /** Makes a world with all bodies of a scene. */
    public Stage(Engine engine, Setting setting, Scene scene) {
        this.scene = scene;
        world = engine.world(scene.effects(), setting);
        scene.build(world);
    }

    /** The world, for reading the state of its bodies; only this class makes its steps. */
    public World world() {
        return world;
    }

    /** Moves the driven bodies, untimed, since it is the bench's work. */
    public void drive() {
        scene.driver().drive(world, made);
    }

    /**
     * Makes a step, after {@link #drive}. The removal of a body is part of it, since waking its
     * neighbours is the engine's work.
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

package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;

import java.util.List;

/** A scene of the bench in a watched pool, with the case's own limit of overlap. */
final class StagedScene {

    private final Scene scene;
    private final WatchedPool pool;
    private final World world;
    private int made;

    StagedScene(Trial trial, Scene scene) {
        this(trial, scene, scene.effects());
    }

    /** The bodies and the driver of a scene under other effects. */
    StagedScene(Trial trial, Scene scene, Effects effects) {
        this.scene = scene;
        pool = trial.pool(effects).withOverlapOfItsOwn();
        scene.bodies().forEach(pool::add);
        world = RigiBoEngine.world(pool.pool());
    }

    WatchedPool pool() {
        return pool;
    }

    /** All bodies, in the order of the scene. */
    List<RigidBody> bodies() {
        return pool.pool().bodies();
    }

    List<RigidBody> dynamic() {
        return bodies().stream().filter(body -> body.type() == BodyType.DYNAMIC).toList();
    }

    /** Moves driven bodies and makes a step of the game's length. */
    void step() {
        scene.driver().drive(world, made);
        pool.step();
        made++;
    }

    /** Makes steps up to a time in s. */
    void runUntil(double seconds) {
        long steps = Math.round(seconds / Trial.DT);
        while (made < steps) {
            step();
        }
    }
}

package rigibo.lab.problem;

import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.probe.DeepestOverlap;
import rigibo.lab.bench.probe.Look;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.LinkErrors;
import rigibo.lab.engine.World;

/** A crowd in its own world, examined after every step. */
final class CrowdWatch {

    private final Bench bench;
    private final Scene scene;
    private final World world;
    private final double start;
    private double work;
    private final LinkErrors joints;
    private double deepest;
    private double jointError;
    private double gain;

    CrowdWatch(Bench bench, Scene scene) {
        this.bench = bench;
        this.scene = scene;
        world = bench.world(scene.effects());
        scene.build(world);
        joints = new LinkErrors(scene.bodies(), scene.links());
        start = Look.at(scene, world).energy();
    }

    /**
     * Strikes a body to the right in the next step. At most that does the work J·v + J²/2m, which
     * it does where nothing is in the body's way.
     *
     * @param impulse J, N·s
     */
    void strike(int body, double impulse) {
        world.push(body, impulse / bench.step(), 0);
        double mass = scene.bodies().get(body).massProperties().mass();
        work += Math.max(0, impulse * (world.velocityX(body) + impulse / (2 * mass)));
    }

    void step() {
        bench.step(world);
        deepest = Math.max(deepest, DeepestOverlap.inWidths(scene, world));
        jointError = Math.max(jointError, joints.worst(world));
        double energy = Look.at(scene, world).energy();
        gain = Math.max(gain, (energy - start - work) / start);
    }

    /** The deepest overlap after any step so far, as a share of the smaller body's width. */
    double deepest() {
        return deepest;
    }

    /** The largest error of a joint after any step so far, m. */
    double jointError() {
        return jointError;
    }

    /** Most energy beyond the start and all strikes, as a share of the start's. */
    double gain() {
        return gain;
    }

    /** m/s. */
    double fastest() {
        double fastest = 0;
        for (int i = 0; i < scene.bodies().size(); i++) {
            double speed = Math.hypot(world.velocityX(i), world.velocityY(i));
            fastest = isMoved(i) ? Math.max(fastest, speed) : fastest;
        }
        return fastest;
    }

    /** How far the last body, the tip of a pyramid, has sunk since the start, m. */
    double sinkingOfLast() {
        int last = scene.bodies().size() - 1;
        return scene.bodies().get(last).y() - world.y(last);
    }

    /** Whether a body is below the floor, whose top is at 0, or has no finite place. */
    boolean isLost() {
        for (int i = 0; i < scene.bodies().size(); i++) {
            if (isMoved(i) && !(world.y(i) > 0)) {
                return true;
            }
        }
        return false;
    }

    private boolean isMoved(int body) {
        return scene.bodies().get(body).type() == BodyType.DYNAMIC;
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;

import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * Mean places and speeds of the bodies in a scene.
 *
 * @param spread mean distance from the middle of all bodies at the end, along x, m
 * @param height mean height at the end, m
 * @param slope angle between straight down and the line from the middle of the supports to the
 *     middle of the bodies, mean over the last third, rad
 * @param energy of motion, mean over all steps, J per kg
 */
record MeansOfRuns(double spread, double height, double slope, double energy) {

    /**
     * Simulates a scene.
     *
     * @param parts of a step of the game in which it is simulated
     */
    static MeansOfRuns of(Scene scene, Accuracy accuracy, int parts, double horizon) {
        Pool pool = new Pool(scene.effects(), accuracy);
        scene.bodies().forEach(pool::add);
        World world = RigiBoEngine.world(pool);
        List<RigidBody> bodies =
                pool.bodies().stream().filter(body -> body.type() == BodyType.DYNAMIC).toList();
        double mass = bodies.stream().mapToDouble(RigidBody::mass).sum();
        long steps = Math.round(horizon / Trial.DT);
        double slope = 0;
        double energy = 0;
        for (int step = 0; step < steps; step++) {
            scene.driver().drive(world, step);
            for (int part = 0; part < parts; part++) {
                pool.step(Trial.DT / parts);
            }
            energy += pool.kineticEnergy() / mass / steps;
            slope += step >= steps - steps / 3 ? slope(pool, bodies) / (steps / 3) : 0;
        }
        double middle = bodies.stream().mapToDouble(RigidBody::x).average().orElse(0);
        double spread =
                bodies.stream().mapToDouble(b -> Math.abs(b.x() - middle)).average().orElse(0);
        double height = bodies.stream().mapToDouble(RigidBody::y).average().orElse(0);
        return new MeansOfRuns(spread, height, slope, energy);
    }

    private static double slope(Pool pool, List<RigidBody> bodies) {
        List<RigidBody> walls =
                pool.bodies().stream().filter(body -> body.type() != BodyType.DYNAMIC).toList();
        double x = mean(bodies, RigidBody::x) - mean(walls, RigidBody::x);
        double y = mean(bodies, RigidBody::y) - mean(walls, RigidBody::y);
        return Math.atan2(x, -y);
    }

    private static double mean(List<RigidBody> bodies, ToDoubleFunction<RigidBody> of) {
        return bodies.stream().mapToDouble(of).average().orElse(0);
    }
}

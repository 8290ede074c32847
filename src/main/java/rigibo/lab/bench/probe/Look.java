package rigibo.lab.bench.probe;

import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.MassProperties;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.World;

import java.util.List;

/**
 * The mean height and the energy of a scene's bodies, computed from their positions and velocities.
 *
 * @param height of the dynamic bodies over the grounds they began over, mean, m
 * @param energy of their motion and of their height over those grounds, J
 */
public record Look(double height, double energy) {

    /** The present height and energy of a world. */
    public static Look at(Scene scene, World world) {
        List<BodyDefinition> bodies = scene.bodies();
        double[] grounds = Grounds.below(bodies);
        double gravity = scene.effects().find(Gravity.class).map(Gravity::y).orElse(0.0);
        double heights = 0;
        double energy = 0;
        for (int i = 0; i < grounds.length; i++) {
            if (bodies.get(i).type() == BodyType.DYNAMIC && i != scene.loss().body()) {
                MassProperties mass = bodies.get(i).massProperties();
                double height = world.y(i) - grounds[i];
                heights += height;
                energy += ofMotion(mass, world, i) - mass.mass() * gravity * height;
            }
        }
        return new Look(heights / scene.dynamic(), energy);
    }

    /** ½·m·v² + ½·I·ω². */
    private static double ofMotion(MassProperties mass, World world, int body) {
        double vx = world.velocityX(body);
        double vy = world.velocityY(body);
        double spin = world.spin(body);
        return (mass.mass() * (vx * vx + vy * vy) + mass.inertia() * spin * spin) / 2;
    }
}

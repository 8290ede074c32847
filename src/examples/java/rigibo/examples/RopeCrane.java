package rigibo.examples;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A crane whose rope is wound in and out, with a load that swings as the crab runs. */
public final class RopeCrane implements Exhibit {

    private static final double SPEED = 0.5; // m/s
    private static final double PERIOD = 8; // s

    RigidBody load;
    Joint rope;
    Joint rail;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
        RigidBody jib = pool.add(BodyDefinition.fixed(Polygon.box(8, 0.3)).at(0, 6.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 6.35)).at(-3.75, 3.175));
        RigidBody crab = pool.add(BodyDefinition.dynamic(Polygon.box(0.8, 0.3)).at(-1, 6.2));
        load = pool.add(BodyDefinition.dynamic(Polygon.box(0.9, 0.9)).at(-1, 1.55));
        rail = pool.join(PrismaticJoint.along(jib, crab, -1, 6.2, 0).limits(-2, 4).motor(0, 2e4));
        rope = pool.join(DistanceJoint.rope(crab, -1, 6.05, load, -1, 2, 4.05));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.7, 0.7)).at(2, 0.35));
    }

    /** Hoists, runs to the right, lowers, and comes back the same way. */
    @Override
    public void beforeStep(Pool pool) {
        double time = pool.time() % PERIOD;
        boolean isEven = (long) (pool.time() / PERIOD) % 2 == 0;
        double run = time > 2 && time < 6 ? isEven ? SPEED : -SPEED : 0;
        rail.motor(1.5 * run, 2e4);
        double hoist = time < 2 ? -SPEED : time > 6 ? SPEED : 0;
        rope.limits(0, length() + hoist / 60);
    }

    /** How much rope is out, m. */
    double length() {
        return rope.definition().settings().limits().upper();
    }

    @Override
    public View view() {
        return new View(0, 3.2, 9);
    }
}

package rigibo.samples.box2d;

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

/** A slide with a spring, one with limits that falls, and one that a motor drives up and down. */
public final class PrismaticSlides implements Exhibit {

    private Joint lift;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
        double up = Math.PI / 2;
        RigidBody sprung = pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.6)).at(-2.6, 4.5));
        pool.join(
                PrismaticJoint.along(floor, sprung, -2.6, 4.5, up).limits(-2, 2).spring(1.5, 0.05));
        RigidBody loose = pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.6)).at(0, 4));
        pool.join(PrismaticJoint.along(floor, loose, 0, 4, up - 0.4).limits(-2.5, 1));
        RigidBody table = pool.add(BodyDefinition.dynamic(Polygon.box(1.4, 0.3)).at(2.6, 1));
        lift = pool.join(PrismaticJoint.along(floor, table, 2.6, 1, up).limits(0, 4).motor(1, 1e4));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.6, 0.6)).at(2.6, 1.5));
    }

    @Override
    public void beforeStep(Pool pool) {
        lift.motor(pool.time() % 8 < 4 ? 1 : -1, 1e4);
    }

    @Override
    public View view() {
        return new View(0, 3, 9);
    }
}

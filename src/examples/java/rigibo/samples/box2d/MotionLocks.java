package rigibo.samples.box2d;

import rigibo.backend.DistanceJoint;
import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A joint of each kind holds a body that is locked in x; the right button locks y, or frees it. */
public final class MotionLocks implements Exhibit {

    private static final double UP = Math.PI / 2;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody beam = pool.add(BodyDefinition.fixed(Polygon.box(12, 0.3)).at(0, 5.5));
        pool.add(BodyDefinition.fixed(Polygon.box(12, 0.5)).at(0, -0.25));
        RigidBody[] held = new RigidBody[5];
        for (int i = 0; i < held.length; i++) {
            held[i] =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(0.8, 0.8))
                                    .at(-4 + 2 * i, 3.5)
                                    .spin(2)
                                    .lockX());
        }
        pool.join(RevoluteJoint.at(beam, held[0], -3.8, 3.9));
        pool.join(PrismaticJoint.along(beam, held[1], -2, 3.5, UP).limits(-2, 1).spring(1, 0.1));
        pool.join(DistanceJoint.rope(beam, 0.3, 5.3, held[2], 0.3, 3.9, 2));
        pool.join(WeldJoint.at(beam, held[3], 2, 4.5).spring(2, 0.1));
        pool.join(WheelJoint.at(beam, held[4], 4, 3.5, UP).limits(-2, 1).spring(1, 0.1));
    }

    @Override
    public void act(Pool pool, double x, double y) {
        pool.bodyAt(x, y).ifPresent(body -> body.yLocked(!body.yLocked()));
    }

    @Override
    public View view() {
        return new View(0, 2.8, 11);
    }
}

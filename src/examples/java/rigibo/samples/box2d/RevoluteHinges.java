package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A ball on a chain, a see-saw with limits, and a mill that a motor turns. */
public final class RevoluteHinges implements Exhibit {

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        RigidBody arm = pool.add(BodyDefinition.dynamic(Polygon.box(2.4, 0.2)).at(-2.6, 4));
        RigidBody post = pool.add(BodyDefinition.fixed(Polygon.box(0.3, 0.3)).at(-3.8, 4));
        pool.join(RevoluteJoint.at(post, arm, -3.8, 4).limits(-1.2, 0.8).spring(1, 0.1));
        RigidBody saw = pool.add(BodyDefinition.dynamic(Polygon.box(4, 0.2)).at(0, 0.8));
        pool.join(RevoluteJoint.at(floor, saw, 0, 0.8).limits(-0.25, 0.25));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.5)).at(-1.4, 1.15));
        pool.add(BodyDefinition.dynamic(new Circle(0.35)).at(1.4, 4));
        RigidBody hub = pool.add(BodyDefinition.fixed(new Circle(0.2)).at(3, 4.4));
        RigidBody mill = pool.add(BodyDefinition.dynamic(Polygon.box(2.4, 0.24)).at(3, 4.4));
        pool.join(RevoluteJoint.at(hub, mill, 3, 4.4).motor(2, 400));
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}

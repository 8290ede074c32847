package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.WheelJoint;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A wheel on a sprung strut that a motor turns, and one that only springs. */
public final class WheelStruts implements Exhibit {

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody beam = pool.add(BodyDefinition.fixed(Polygon.box(7, 0.4)).at(0, 4.6));
        double up = Math.PI / 2;
        RigidBody driven = pool.add(BodyDefinition.dynamic(new Circle(0.7)).at(-1.8, 3).mass(10));
        pool.join(
                WheelJoint.at(beam, driven, -1.8, 3, up).limits(-2, 1).spring(1, 0.1).motor(4, 20));
        RigidBody free = pool.add(BodyDefinition.dynamic(new Capsule(0.5, 0.3)).at(1.8, 3));
        pool.join(WheelJoint.at(beam, free, 1.8, 3, up - 0.3).limits(-2, 1).spring(1, 0.3));
    }

    @Override
    public View view() {
        return new View(0, 3, 8);
    }
}

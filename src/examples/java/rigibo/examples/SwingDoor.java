package rigibo.examples;

import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Seen from above: balls push a door open, and its spring closes it again. */
public final class SwingDoor implements Exhibit {

    RigidBody door;
    RigidBody ball;
    Joint hinge;

    @Override
    public Effects effects() {
        return Effects.of(
                new Contacts(), new Rotation(), new Joints(), new ContinuousImpacts(), new Drag());
    }

    @Override
    public void build(Pool pool) {
        RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(0.3, 2.6)).at(0, 4.3));
        pool.add(BodyDefinition.fixed(Polygon.box(0.3, 2)).at(0, 0));
        door = pool.add(BodyDefinition.dynamic(Polygon.box(0.16, 1.9)).at(0, 2.02).mass(20));
        hinge = pool.join(RevoluteJoint.at(wall, door, 0, 2.95).limits(-1.4, 1.4).spring(0.5, 0.7));
        ball = shoot(pool, -2.5, 1.3);
    }

    private static RigidBody shoot(Pool pool, double x, double y) {
        return pool.add(BodyDefinition.dynamic(new Circle(0.25)).at(x, y).velocity(5, 0).mass(4));
    }

    @Override
    public void act(Pool pool, double x, double y) {
        shoot(pool, x, y);
    }

    @Override
    public View view() {
        return new View(0, 2.2, 8);
    }
}

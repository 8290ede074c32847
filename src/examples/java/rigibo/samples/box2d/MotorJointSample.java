package rigibo.samples.box2d;

import rigibo.backend.Joint;
import rigibo.backend.MotorJoint;
import rigibo.backend.MouseJoint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A plate follows a target with limited force and torque, and carries the bodies on it. */
public final class MotorJointSample implements Exhibit {

    private static final double HEIGHT = 3; // m
    private RigidBody plate;
    private Joint hand;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
        plate = pool.add(BodyDefinition.dynamic(Polygon.box(3, 0.3)).at(0, HEIGHT).mass(50));
        hand = pool.join(MouseJoint.of(floor, plate, 0, HEIGHT));
        pool.join(MotorJoint.friction(floor, plate, 0, 800));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.6, 0.6)).at(0, HEIGHT + 0.45).mass(5));
    }

    /** Along an eight that lies. */
    @Override
    public void beforeStep(Pool pool) {
        double angle = 0.8 * pool.time();
        hand.target(2 * Angle.sin(angle), HEIGHT + 0.8 * Angle.sin(2 * angle));
    }

    @Override
    public View view() {
        return new View(0, 3, 9);
    }
}

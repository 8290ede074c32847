package rigibo.samples.box2d;

import rigibo.backend.Explosion;
import rigibo.backend.MotorJoint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Seen from above: friction with the ground brakes whatever is flung about. */
public final class TopDownFriction implements Exhibit {

    private static final double GRIP = 3; // m/s²

    @Override
    public Effects effects() {
        return Effects.of(
                new Contacts(),
                new Rotation(),
                new Friction(),
                new Restitution(),
                new ContinuousImpacts(),
                new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody ground = pool.add(BodyDefinition.fixed(Chain.loop(-4, 0, -4, 8, 4, 8, 4, 0)));
        for (int i = 0; i < 25; i++) {
            double x = 1.3 * (i % 5 - 2);
            double y = 1.4 + 1.3 * (i / 5);
            Shape shape =
                    switch (i % 3) {
                        case 0 -> new Circle(0.35);
                        case 1 -> new Capsule(0.25, 0.2);
                        default -> Polygon.box(0.6, 0.6);
                    };
            RigidBody body = pool.add(BodyDefinition.dynamic(shape).at(x, y).angle(i).mass(2));
            double torque = 2 * GRIP * 0.2;
            pool.join(MotorJoint.friction(ground, body, 2 * GRIP, torque).collideConnected(true));
        }
        pool.explode(Explosion.at(0.2, 3.8).radius(3).impulsePerMetre(8));
    }

    @Override
    public void act(Pool pool, double x, double y) {
        pool.explode(Explosion.at(x, y).radius(3).impulsePerMetre(8));
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}

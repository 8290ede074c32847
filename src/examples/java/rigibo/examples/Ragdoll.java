package rigibo.examples;

import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Length;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** Eleven bones and ten hinges with limits, each held a little by a motor that stands still. */
public final class Ragdoll implements Exhibit {

    /** Torque by which a joint resists, N·m for each kg of the bone that it moves. */
    private static final double STIFFNESS = 0.15;

    final List<Joint> joints = new ArrayList<>();
    final List<RigidBody> bones = new ArrayList<>();

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(2.4, 0.3)).at(0.9, 0.8).angle(-0.5));
        RigidBody hip = bone(pool, 0, 3.2, 0, 3.5, 0.16);
        RigidBody chest = bone(pool, 0, 3.6, 0, 4, 0.18);
        hinge(pool, hip, chest, 0, 3.55, -0.3, 0.7);
        RigidBody head = pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0, 4.45).group(1));
        bones.add(head);
        hinge(pool, chest, head, 0, 4.22, -0.4, 0.4);
        for (int side = -1; side <= 1; side += 2) {
            RigidBody upper = bone(pool, 0, 4, 0.5 * side, 4, 0.08);
            RigidBody lower = bone(pool, 0.55 * side, 4, 1 * side, 4, 0.07);
            hinge(pool, chest, upper, 0, 4, -1.5, 1.5);
            hinge(pool, upper, lower, 0.52 * side, 4, side < 0 ? -2 : 0, side < 0 ? 0 : 2);
            RigidBody thigh = bone(pool, 0.1 * side, 3.1, 0.14 * side, 2.55, 0.1);
            RigidBody shin = bone(pool, 0.14 * side, 2.45, 0.16 * side, 1.95, 0.08);
            hinge(pool, hip, thigh, 0.1 * side, 3.1, -0.6, 1.2);
            hinge(pool, thigh, shin, 0.14 * side, 2.5, -1.6, 0.05);
        }
    }

    private RigidBody bone(Pool pool, double x1, double y1, double x2, double y2, double radius) {
        double half = Length.hypot(x2 - x1, y2 - y1) / 2;
        RigidBody bone =
                pool.add(
                        BodyDefinition.dynamic(new Capsule(half, radius))
                                .at((x1 + x2) / 2, (y1 + y2) / 2)
                                .angle(Angle.atan2(y2 - y1, x2 - x1))
                                .group(1));
        bones.add(bone);
        return bone;
    }

    private void hinge(
            Pool pool, RigidBody a, RigidBody b, double x, double y, double lower, double upper) {
        JointDefinition hinge = RevoluteJoint.at(a, b, x, y).limits(lower, upper);
        joints.add(pool.join(hinge.motor(0, STIFFNESS * b.mass())));
    }

    @Override
    public View view() {
        return new View(0, 2.4, 8);
    }
}

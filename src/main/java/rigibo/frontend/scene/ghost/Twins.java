package rigibo.frontend.scene.ghost;

import rigibo.backend.DistanceJoint;
import rigibo.backend.FilterJoint;
import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.MotorJoint;
import rigibo.backend.MouseJoint;
import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.PulleyJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;

import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.Map;

/** Maps each body and joint of the original to its copy. */
final class Twins {

    private final Map<RigidBody, RigidBody> bodies = new IdentityHashMap<>();
    private final Map<Joint, Joint> joints = new IdentityHashMap<>();

    /** A copy that was made just now: its lists have the original's order. */
    Twins(Pool original, Pool copy) {
        Iterator<RigidBody> copies = copy.bodies().iterator();
        original.bodies().forEach(body -> bodies.put(body, copies.next()));
        Iterator<Joint> joined = copy.joints().iterator();
        original.joints().forEach(joint -> joints.put(joint, joined.next()));
    }

    void put(RigidBody body, RigidBody twin) {
        bodies.put(body, twin);
    }

    void put(Joint joint, Joint twin) {
        joints.put(joint, twin);
    }

    RigidBody of(RigidBody body) {
        return bodies.get(body);
    }

    Joint of(Joint joint) {
        return joints.get(joint);
    }

    RigidBody drop(RigidBody body) {
        return bodies.remove(body);
    }

    Joint drop(Joint joint) {
        return joints.remove(joint);
    }

    /** Returns a joint's definition between the twins of its bodies. */
    JointDefinition of(JointDefinition of) {
        RigidBody a = of(of.a());
        RigidBody b = of(of.b());
        return switch (of.kind()) {
            case REVOLUTE -> {
                RevoluteJoint j = (RevoluteJoint) of;
                yield new RevoluteJoint(a, b, j.frameA(), j.frameB(), j.settings());
            }
            case PRISMATIC -> {
                PrismaticJoint j = (PrismaticJoint) of;
                yield new PrismaticJoint(a, b, j.frameA(), j.frameB(), j.settings());
            }
            case DISTANCE -> {
                DistanceJoint j = (DistanceJoint) of;
                yield new DistanceJoint(a, b, j.frameA(), j.frameB(), j.length(), j.settings());
            }
            case WELD -> {
                WeldJoint j = (WeldJoint) of;
                yield new WeldJoint(a, b, j.frameA(), j.frameB(), j.settings());
            }
            case WHEEL -> {
                WheelJoint j = (WheelJoint) of;
                yield new WheelJoint(a, b, j.frameA(), j.frameB(), j.settings());
            }
            case MOTOR -> motor((MotorJoint) of, a, b);
            case MOUSE -> mouse((MouseJoint) of, a, b);
            case GEAR -> gear((GearJoint) of);
            case PULLEY -> pulley((PulleyJoint) of, a, b);
            case FILTER -> new FilterJoint(a, b);
        };
    }

    private static JointDefinition motor(MotorJoint j, RigidBody a, RigidBody b) {
        return new MotorJoint(
                a,
                b,
                j.velocityX(),
                j.velocityY(),
                j.angularVelocity(),
                j.mostForce(),
                j.mostTorque(),
                j.settings());
    }

    private static JointDefinition mouse(MouseJoint j, RigidBody a, RigidBody b) {
        return new MouseJoint(
                a, b, j.frameB(), j.targetX(), j.targetY(), j.mostForce(), j.settings());
    }

    private JointDefinition gear(GearJoint j) {
        return new GearJoint(of(j.first()), of(j.second()), j.ratio(), j.settings());
    }

    private static JointDefinition pulley(PulleyJoint j, RigidBody a, RigidBody b) {
        return new PulleyJoint(
                a,
                b,
                j.frameA(),
                j.frameB(),
                j.groundAX(),
                j.groundAY(),
                j.groundBX(),
                j.groundBY(),
                j.ratio(),
                j.length(),
                j.settings());
    }
}

package rigibo.peers.jbox2d;

import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.joints.DistanceJointDef;
import org.jbox2d.dynamics.joints.JointDef;
import org.jbox2d.dynamics.joints.PrismaticJointDef;
import org.jbox2d.dynamics.joints.RevoluteJointDef;
import org.jbox2d.dynamics.joints.WeldJointDef;
import org.jbox2d.dynamics.joints.WheelJointDef;

import rigibo.backend.setup.JointSettings;
import rigibo.lab.engine.Link;
import rigibo.peers.Box2dFamily;

/** Our joints as JBox2D's. */
final class Connections {

    private Connections() {}

    /**
     * Translates a joint.
     *
     * @throws UnsupportedOperationException naming what the engine lacks
     */
    static JointDef of(Link link, Body a, Body b) {
        Vec2 at = new Vec2((float) link.x(), (float) link.y());
        Vec2 to = new Vec2((float) link.toX(), (float) link.toY());
        Box2dFamily.requireKnown(link);
        return switch (link.kind()) {
            case REVOLUTE -> hinge(link.settings(), a, b, at);
            case DISTANCE -> rod(link.settings(), a, b, at, to);
            case WHEEL -> wheel(link.settings(), a, b, at, axis(at, to));
            case PRISMATIC -> slide(link.settings(), a, b, at, axis(at, to));
            case WELD -> weld(link.settings(), a, b, at);
            case MOTOR, MOUSE, GEAR, PULLEY, FILTER -> throw link.unknown();
        };
    }

    private static JointDef hinge(JointSettings settings, Body a, Body b, Vec2 at) {
        RevoluteJointDef hinge = new RevoluteJointDef();
        hinge.initialize(a, b, at);
        hinge.enableLimit = settings.limits().areAny();
        hinge.lowerAngle = (float) settings.limits().lower();
        hinge.upperAngle = (float) settings.limits().upper();
        hinge.enableMotor = settings.motor().drives();
        hinge.motorSpeed = (float) settings.motor().speed();
        hinge.maxMotorTorque = (float) settings.motor().most();
        return hinge;
    }

    private static JointDef rod(JointSettings settings, Body a, Body b, Vec2 at, Vec2 to) {
        DistanceJointDef rod = new DistanceJointDef();
        rod.initialize(a, b, at, to);
        rod.frequencyHz = (float) settings.spring().hertz();
        rod.dampingRatio = (float) settings.spring().dampingRatio();
        return rod;
    }

    private static JointDef wheel(JointSettings settings, Body a, Body b, Vec2 at, Vec2 axis) {
        WheelJointDef wheel = new WheelJointDef();
        wheel.initialize(a, b, at, axis);
        wheel.frequencyHz = (float) settings.spring().hertz();
        wheel.dampingRatio = (float) settings.spring().dampingRatio();
        wheel.enableMotor = settings.motor().drives();
        wheel.motorSpeed = (float) settings.motor().speed();
        wheel.maxMotorTorque = (float) settings.motor().most();
        return wheel;
    }

    private static JointDef slide(JointSettings settings, Body a, Body b, Vec2 at, Vec2 axis) {
        PrismaticJointDef slide = new PrismaticJointDef();
        slide.initialize(a, b, at, axis);
        slide.enableLimit = settings.limits().areAny();
        slide.lowerTranslation = (float) settings.limits().lower();
        slide.upperTranslation = (float) settings.limits().upper();
        slide.enableMotor = settings.motor().drives();
        slide.motorSpeed = (float) settings.motor().speed();
        slide.maxMotorForce = (float) settings.motor().most();
        return slide;
    }

    private static JointDef weld(JointSettings settings, Body a, Body b, Vec2 at) {
        WeldJointDef weld = new WeldJointDef();
        weld.initialize(a, b, at);
        weld.frequencyHz = (float) settings.spring().hertz();
        weld.dampingRatio = (float) settings.spring().dampingRatio();
        return weld;
    }

    private static Vec2 axis(Vec2 from, Vec2 to) {
        Vec2 axis = to.sub(from);
        axis.normalize();
        return axis;
    }
}

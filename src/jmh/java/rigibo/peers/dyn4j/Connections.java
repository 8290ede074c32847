package rigibo.peers.dyn4j;

import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.joint.DistanceJoint;
import org.dyn4j.dynamics.joint.Joint;
import org.dyn4j.dynamics.joint.PrismaticJoint;
import org.dyn4j.dynamics.joint.RevoluteJoint;
import org.dyn4j.dynamics.joint.WeldJoint;
import org.dyn4j.dynamics.joint.WheelJoint;
import org.dyn4j.geometry.Vector2;

import rigibo.backend.setup.JointSettings;
import rigibo.lab.engine.Link;

/** Our joints as dyn4j's. */
final class Connections {

    private Connections() {}

    /**
     * Translates a joint.
     *
     * @throws UnsupportedOperationException naming what the engine lacks
     */
    static Joint<Body> of(Link link, Body a, Body b) {
        Vector2 at = new Vector2(link.x(), link.y());
        Vector2 to = new Vector2(link.toX(), link.toY());
        return switch (link.kind()) {
            case REVOLUTE -> hinge(link.settings(), a, b, at);
            case DISTANCE -> rod(link.settings(), a, b, at, to);
            case WHEEL -> wheel(link.settings(), a, b, at, at.to(to));
            case PRISMATIC -> slide(link.settings(), a, b, at, at.to(to));
            case WELD -> weld(link.settings(), a, b, at);
            case MOTOR, MOUSE, GEAR, PULLEY, FILTER -> throw link.unknown();
        };
    }

    private static Joint<Body> hinge(JointSettings settings, Body a, Body b, Vector2 at) {
        if (settings.spring().isThere()) {
            throw new UnsupportedOperationException("hinges on springs");
        }
        RevoluteJoint<Body> hinge = new RevoluteJoint<>(a, b, at);
        if (settings.limits().areAny()) {
            hinge.setLimitsEnabled(settings.limits().lower(), settings.limits().upper());
        }
        hinge.setMotorEnabled(settings.motor().drives());
        hinge.setMotorSpeed(settings.motor().speed());
        hinge.setMaximumMotorTorqueEnabled(settings.motor().drives());
        hinge.setMaximumMotorTorque(settings.motor().most());
        return hinge;
    }

    private static Joint<Body> rod(JointSettings settings, Body a, Body b, Vector2 at, Vector2 to) {
        DistanceJoint<Body> rod = new DistanceJoint<>(a, b, at, to);
        if (settings.spring().isThere()) {
            rod.setSpringEnabled(true);
            rod.setSpringDamperEnabled(true);
            rod.setSpringFrequency(settings.spring().hertz());
            rod.setSpringDampingRatio(settings.spring().dampingRatio());
        }
        return rod;
    }

    private static Joint<Body> wheel(
            JointSettings settings, Body a, Body b, Vector2 at, Vector2 axis) {
        WheelJoint<Body> wheel = new WheelJoint<>(a, b, at, axis);
        wheel.setSpringEnabled(settings.spring().isThere());
        wheel.setSpringDamperEnabled(settings.spring().isThere());
        if (settings.spring().isThere()) {
            wheel.setSpringFrequency(settings.spring().hertz());
            wheel.setSpringDampingRatio(settings.spring().dampingRatio());
        }
        wheel.setMotorEnabled(settings.motor().drives());
        wheel.setMotorSpeed(settings.motor().speed());
        wheel.setMaximumMotorTorqueEnabled(settings.motor().drives());
        wheel.setMaximumMotorTorque(settings.motor().most());
        return wheel;
    }

    private static Joint<Body> slide(
            JointSettings settings, Body a, Body b, Vector2 at, Vector2 axis) {
        PrismaticJoint<Body> slide = new PrismaticJoint<>(a, b, at, axis);
        if (settings.limits().areAny()) {
            slide.setLimitsEnabled(settings.limits().lower(), settings.limits().upper());
        }
        if (settings.spring().isThere()) {
            slide.setSpringEnabled(true);
            slide.setSpringDamperEnabled(true);
            slide.setSpringFrequency(settings.spring().hertz());
            slide.setSpringDampingRatio(settings.spring().dampingRatio());
        }
        slide.setMotorEnabled(settings.motor().drives());
        slide.setMotorSpeed(settings.motor().speed());
        slide.setMaximumMotorForceEnabled(settings.motor().drives());
        slide.setMaximumMotorForce(settings.motor().most());
        return slide;
    }

    private static Joint<Body> weld(JointSettings settings, Body a, Body b, Vector2 at) {
        WeldJoint<Body> weld = new WeldJoint<>(a, b, at);
        if (settings.spring().isThere()) {
            weld.setSpringEnabled(true);
            weld.setSpringDamperEnabled(true);
            weld.setSpringFrequency(settings.spring().hertz());
            weld.setSpringDampingRatio(settings.spring().dampingRatio());
        }
        return weld;
    }
}

package rigibo.lab.engine;

import rigibo.backend.DistanceJoint;
import rigibo.backend.JointDefinition;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;

import java.util.Objects;

/**
 * A joint between two bodies of a scene at their initial places, of a kind that every engine has.
 *
 * @param kind one of revolute, weld, prismatic, wheel and distance
 * @param a number of the first body
 * @param b number of the second body
 * @param x world x of the point where it holds both, of a rod where it holds A, m
 * @param y world y of it, m
 * @param toX of a slide and a wheel another point of its axis; of a rod where it holds B, m
 * @param toY its world y, m
 * @param settings limits, motor, spring
 */
public record Link(
        JointKind kind,
        int a,
        int b,
        double x,
        double y,
        double toX,
        double toY,
        JointSettings settings) {

    /** A hinge. */
    public static Link hinge(int a, int b, double x, double y) {
        return new Link(JointKind.REVOLUTE, a, b, x, y, x, y, JointSettings.NONE);
    }

    /** A weld. */
    public static Link weld(int a, int b, double x, double y) {
        return new Link(JointKind.WELD, a, b, x, y, x, y, JointSettings.NONE);
    }

    /** A slide along an axis to another point. */
    public static Link slide(int a, int b, double x, double y, double toX, double toY) {
        return new Link(JointKind.PRISMATIC, a, b, x, y, toX, toY, JointSettings.NONE);
    }

    /** A wheel b on a strut along an axis to another point. */
    public static Link wheel(int a, int b, double x, double y, double toX, double toY) {
        return new Link(JointKind.WHEEL, a, b, x, y, toX, toY, JointSettings.NONE);
    }

    /** A rod between two points. */
    public static Link rod(int a, double x, double y, int b, double toX, double toY) {
        return new Link(JointKind.DISTANCE, a, b, x, y, toX, toY, JointSettings.NONE);
    }

    private Link with(JointSettings other) {
        return new Link(kind, a, b, x, y, toX, toY, other);
    }

    /** A copy with limits, rad or m. */
    public Link limits(double lower, double upper) {
        return with(settings.limits(new JointLimits(lower, upper, 0)));
    }

    /** A copy with a motor: its speed, rad/s or m/s, and its greatest torque or force, N·m or N. */
    public Link motor(double speed, double most) {
        return with(settings.motor(new JointMotor(speed, most)));
    }

    /** A copy with a spring. */
    public Link spring(double hertz, double dampingRatio) {
        return with(settings.spring(new JointSpring(hertz, dampingRatio)));
    }

    /** Whether it joins two bodies. */
    public boolean isOf(int one, int other) {
        return a == one && b == other || a == other && b == one;
    }

    /** Whether it is a rod whose length a spring lets change. */
    public boolean isSpring() {
        return kind == JointKind.DISTANCE && settings.spring().isThere();
    }

    /** The definition of the joint for our engine. */
    public JointDefinition between(RigidBody first, RigidBody second) {
        double axis = Math.atan2(toY - y, toX - x);
        JointDefinition joint =
                switch (kind) {
                    case REVOLUTE -> RevoluteJoint.at(first, second, x, y);
                    case WELD -> WeldJoint.at(first, second, x, y);
                    case PRISMATIC -> PrismaticJoint.along(first, second, x, y, axis);
                    case WHEEL -> WheelJoint.at(first, second, x, y, axis);
                    case DISTANCE -> DistanceJoint.rod(first, x, y, second, toX, toY);
                    case MOTOR, MOUSE, GEAR, PULLEY, FILTER -> throw unknown();
                };
        return joint.with(settings);
    }

    /** The exception of an engine that has no such joint. */
    public UnsupportedOperationException unknown() {
        return new UnsupportedOperationException("joints of the kind " + kind);
    }

    /** A hash that is the same on every machine, unlike the hashes of enums. */
    public int fingerprint() {
        return Objects.hash(kind.name(), a, b, x, y, toX, toY, settings);
    }
}

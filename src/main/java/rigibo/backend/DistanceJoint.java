package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * Controls the distance between a point of A and a point of B; that distance is the joint's
 * coordinate, m. Without limits, motor and spring it is a rod of the given length. With limits it
 * is a rope or a strut whose distance stays within them. With a spring, {@code length} is the
 * spring's rest length.
 *
 * <pre>{@code
 * RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 3)));
 * pool.join(DistanceJoint.rod(wall, 0, 1, crate, 2, 1));
 * pool.join(DistanceJoint.rope(wall, 0, 1, crate, 2, 1, 2.5)); // slack below 2.5 m
 * }</pre>
 *
 * @param a the first body
 * @param b the second body, whose motion relative to A is the coordinate
 * @param frameA anchor and axis on A
 * @param frameB anchor on B
 * @param length m, 0 or more
 * @param settings limits (m), motor (m/s, N), spring
 */
public record DistanceJoint(
        RigidBody a,
        RigidBody b,
        JointFrame frameA,
        JointFrame frameB,
        double length,
        JointSettings settings)
        implements JointDefinition {

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is missing or out of its range
     */
    public DistanceJoint {
        JointEnds.require("DistanceJoint", a, b);
        Require.present("DistanceJoint.frameA", frameA);
        Require.present("DistanceJoint.frameB", frameB);
        Require.notNegative("DistanceJoint.length", length, "m");
        Require.present("DistanceJoint.settings", settings)
                .requireOnly(
                        "DistanceJoint",
                        JointSettings.Part.LIMITS,
                        JointSettings.Part.MOTOR,
                        JointSettings.Part.SPRING);
    }

    /** A rod between a world point (m) on A and one on B, as long as their present distance. */
    public static DistanceJoint rod(
            RigidBody a, double ax, double ay, RigidBody b, double bx, double by) {
        JointEnds.require("DistanceJoint", a, b);
        double length = Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
        return new DistanceJoint(
                a,
                b,
                JointEnds.frame(a, ax, ay, a.angle()),
                JointEnds.frame(b, bx, by, b.angle()),
                length,
                JointSettings.NONE);
    }

    /**
     * A rope between a world point (m) on A and one on B, slack below its length {@code most}, m.
     */
    public static DistanceJoint rope(
            RigidBody a, double ax, double ay, RigidBody b, double bx, double by, double most) {
        Require.positive("DistanceJoint.rope most", most, "m");
        DistanceJoint rod = rod(a, ax, ay, b, bx, by);
        return rod.with(rod.settings.limits(new JointLimits(0, most, 0)));
    }

    /** A copy with another length, m. */
    public DistanceJoint length(double metres) {
        return new DistanceJoint(a, b, frameA, frameB, metres, settings);
    }

    /** Whether the joint is a rod: it has no limits, spring or motor. */
    public boolean isRod() {
        return !settings.limits().areAny()
                && !settings.spring().isThere()
                && !settings.motor().drives();
    }

    @Override
    public DistanceJoint with(JointSettings other) {
        return new DistanceJoint(a, b, frameA, frameB, length, other);
    }

    @Override
    public JointKind kind() {
        return JointKind.DISTANCE;
    }
}

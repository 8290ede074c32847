package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * A point of A and a point of B at a distance: its coordinate, m. Without limits and spring it is a
 * rod of a length; with limits a rope, or a strut that stays within them; with a spring one whose
 * length without load is that length.
 *
 * <pre>{@code
 * RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 3)));
 * pool.join(DistanceJoint.rod(wall, 0, 1, crate, 2, 1));
 * pool.join(DistanceJoint.rope(wall, 0, 1, crate, 2, 1, 2.5)); // slack below 2.5 m
 * }</pre>
 *
 * @param a the first body
 * @param b the second body, whose coordinate is told
 * @param frameA where the joint holds A, and its axis
 * @param frameB where it holds B
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

    /** A rod between a world point (m) on A and one on B, as long as they are apart now. */
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

    /** A rope between them that is no longer than so many m, and slack below. */
    public static DistanceJoint rope(
            RigidBody a, double ax, double ay, RigidBody b, double bx, double by, double most) {
        Require.positive("DistanceJoint.rope most", most, "m");
        DistanceJoint rod = rod(a, ax, ay, b, bx, by);
        return rod.with(rod.settings.limits(new JointLimits(0, most, 0)));
    }

    /** A copy with another length without load, m. */
    public DistanceJoint length(double metres) {
        return new DistanceJoint(a, b, frameA, frameB, metres, settings);
    }

    /** Whether the distance is held: no limits, spring or motor leave it any freedom. */
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

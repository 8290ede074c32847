package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;

/**
 * Couples the coordinates of two hinges or slides: q₁ + ratio·q₂ keeps the value it had when they
 * were coupled. The A bodies of the two joints take the reaction. When one of the two joints is
 * removed or breaks, the gear is removed too.
 *
 * <pre>{@code
 * RigidBody frame = pool.add(BodyDefinition.fixed(Polygon.box(4, 0.1)));
 * RigidBody small = pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(-1, 0));
 * RigidBody large = pool.add(BodyDefinition.dynamic(new Circle(1)).at(1, 0));
 * Joint first = pool.join(RevoluteJoint.at(frame, small, -1, 0).motor(2, 5));
 * Joint second = pool.join(RevoluteJoint.at(frame, large, 1, 0));
 * pool.join(GearJoint.of(first, second, 2)); // the large one turns back at half the speed
 * }</pre>
 *
 * @param first a revolute or prismatic joint
 * @param second another revolute or prismatic joint
 * @param ratio not 0; with −1 both turn the same way, with 1 in opposite directions
 * @param settings breaking loads and whether the two driven bodies collide
 */
public record GearJoint(Joint first, Joint second, double ratio, JointSettings settings)
        implements JointDefinition {

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is missing or out of its range
     */
    public GearJoint {
        requireGeared("GearJoint.first", first);
        requireGeared("GearJoint.second", second);
        if (first == second || first.b() == second.b()) {
            throw new IllegalArgumentException(
                    "GearJoint.second must drive another body than first, was " + second);
        }
        if (!(ratio != 0 && Math.abs(ratio) < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "GearJoint.ratio must be finite and not 0 (no unit), was " + ratio);
        }
        Require.present("GearJoint.settings", settings).requireOnly("GearJoint");
    }

    /** A gear between two joints with {@link JointSettings#NONE}. */
    public static GearJoint of(Joint first, Joint second, double ratio) {
        return new GearJoint(first, second, ratio, JointSettings.NONE);
    }

    private static void requireGeared(String field, Joint joint) {
        JointKind kind = Require.present(field, joint).kind();
        if (kind != JointKind.REVOLUTE && kind != JointKind.PRISMATIC) {
            throw new IllegalArgumentException(
                    field + " must be a revolute or prismatic joint, was " + kind);
        }
    }

    /** The body that the first joint drives. */
    @Override
    public RigidBody a() {
        return first.b();
    }

    /** The body that the second joint drives. */
    @Override
    public RigidBody b() {
        return second.b();
    }

    @Override
    public GearJoint with(JointSettings other) {
        return new GearJoint(first, second, ratio, other);
    }

    @Override
    public JointKind kind() {
        return JointKind.GEAR;
    }
}

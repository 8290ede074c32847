package rigibo.frontend.puzzle.level;

import rigibo.backend.DistanceJoint;
import rigibo.backend.JointDefinition;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;
import rigibo.backend.geometry.Length;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.exc.JsonNodeException;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A joint between two bodies of a level.
 *
 * @param type its kind
 * @param a id of a body, {@code ball}, {@code ball2} … or {@code platform}
 * @param b id of the other one, which a motor drives
 * @param x of the point where it holds A, or both, world m
 * @param y of that point, world m, up
 * @param toX x of the point where it holds B, world m; equal to x for a joint at one point
 * @param toY y of that point, world m, up
 * @param axis rad, for a slide and a wheel
 * @param length m, for a spring without load
 * @param settings limits, motor, spring, and the force at which it breaks
 * @param id unique in its level, where it has one; what a click acts on has one
 * @param handling what a click does to it
 */
public record LevelJoint(
        Type type,
        String a,
        String b,
        double x,
        double y,
        double toX,
        double toY,
        double axis,
        double length,
        JointSettings settings,
        Optional<String> id,
        Handling handling) {

    private static final Pattern BALL = Pattern.compile("ball([2-4])");

    /** The kinds of joints, with their names in files. */
    public enum Type {
        HINGE,
        WELD,
        WHEEL,
        SLIDE,
        ROD,
        ROPE,
        SPRING;

        /** Whether it connects two points, not one. */
        public boolean hasTwoPoints() {
            return this == ROD || this == ROPE || this == SPRING;
        }
    }

    /** The joint of a file's node; empty if the node cannot be a joint. */
    public static Optional<LevelJoint> of(JsonNode node) {
        try {
            return Optional.of(JointReader.joint(node));
        } catch (IllegalArgumentException | JsonNodeException refused) {
            return Optional.empty();
        }
    }

    /** Name of the platform in joints. */
    static final String PLATFORM = "platform";

    /** Name of a ball in joints, from 0. */
    static String ball(int index) {
        return index == 0 ? "ball" : "ball" + (index + 1);
    }

    /** Name of an end for players: a body's id, or a word of the bundles after {@code @}. */
    static String shown(String end) {
        if (end.equals(PLATFORM)) {
            return "@editor.platform";
        }
        return ball(end).isPresent() ? "@editor.ball" : end;
    }

    /** Number of the ball that a name means, from 0; empty if it means the platform or a body. */
    public static Optional<Integer> ball(String name) {
        if (name.equals(ball(0))) {
            return Optional.of(0);
        }
        Matcher number = BALL.matcher(name);
        return number.matches()
                ? Optional.of(Integer.parseInt(number.group(1)) - 1)
                : Optional.empty();
    }

    /** The action of a click on it; empty if there is none. */
    public Optional<Verb> verb() {
        return handling.verb();
    }

    /** Distance of its ends, m. */
    double span() {
        return Length.hypot(toX - x, toY - y);
    }

    /** The engine's definition, with the bodies at the places of the level. */
    public JointDefinition definition(RigidBody one, RigidBody other) {
        JointDefinition plain =
                switch (type) {
                    case HINGE -> RevoluteJoint.at(one, other, x, y);
                    case WELD -> WeldJoint.at(one, other, x, y);
                    case WHEEL -> WheelJoint.at(one, other, x, y, axis);
                    case SLIDE -> PrismaticJoint.along(one, other, x, y, axis);
                    case ROD, ROPE -> DistanceJoint.rod(one, x, y, other, toX, toY);
                    case SPRING -> DistanceJoint.rod(one, x, y, other, toX, toY).length(length);
                };
        return plain.with(handling.beginsOff() ? settings.motor(JointMotor.NONE) : settings);
    }
}

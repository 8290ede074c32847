package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Length;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;

import tools.jackson.databind.JsonNode;

import java.util.Locale;
import java.util.Optional;

/** Turns a joint that the schema accepts into a record; degrees become radians. */
final class JointReader {

    /** Default axes: a strut is upright, a slide is level. */
    private static final double UPRIGHT = 90;

    private JointReader() {}

    static LevelJoint joint(JsonNode node) {
        LevelJoint.Type type =
                LevelJoint.Type.valueOf(node.path("type").asString().toUpperCase(Locale.ROOT));
        String first = type.hasTwoPoints() ? "from" : "at";
        String second = type.hasTwoPoints() ? "to" : "at";
        double x = node.path(first).path(0).asDouble();
        double y = node.path(first).path(1).asDouble();
        double toX = node.path(second).path(0).asDouble();
        double toY = node.path(second).path(1).asDouble();
        double usualAxis = type == LevelJoint.Type.WHEEL ? UPRIGHT : 0;
        double length = node.path("length").asDouble(Length.hypot(toX - x, toY - y));
        return new LevelJoint(
                type,
                node.path("a").asString(),
                node.path("b").asString(),
                x,
                y,
                toX,
                toY,
                Angle.ofDegrees(node.path("axis").asDouble(usualAxis)),
                length,
                settings(node, type, length),
                Optional.of(node.path("id").asString("")).filter(id -> !id.isEmpty()),
                Handling.of(node));
    }

    private static JointSettings settings(JsonNode node, LevelJoint.Type type, double length) {
        JointSettings settings =
                JointSettings.NONE
                        .limits(limits(node, type, length))
                        .breaking(
                                node.path("breakForce").asDouble(Double.POSITIVE_INFINITY),
                                Double.POSITIVE_INFINITY);
        JsonNode motor = node.path("motor");
        if (motor.isObject()) {
            settings =
                    settings.motor(
                            new JointMotor(
                                    motor.path("speed").asDouble(), motor.path("most").asDouble()));
        }
        JsonNode spring = node.path("spring");
        return spring.isObject()
                ? settings.spring(
                        new JointSpring(
                                spring.path("hertz").asDouble(),
                                spring.path("damping").asDouble(0)))
                : settings;
    }

    private static JointLimits limits(JsonNode node, LevelJoint.Type type, double length) {
        if (type == LevelJoint.Type.ROPE) {
            return new JointLimits(0, length, 0);
        }
        JsonNode limits = node.path("limits");
        if (!limits.isArray() || limits.path(0).asDouble() > limits.path(1).asDouble()) {
            return JointLimits.NONE;
        }
        double unit = type == LevelJoint.Type.HINGE ? Angle.ofDegrees(1) : 1;
        return new JointLimits(
                unit * limits.path(0).asDouble(), unit * limits.path(1).asDouble(), 0);
    }
}

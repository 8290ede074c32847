package rigibo.fuzz.program;

import static rigibo.fuzz.program.Stated.call;

import rigibo.backend.DistanceJoint;
import rigibo.backend.FilterJoint;
import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.MotorJoint;
import rigibo.backend.MouseJoint;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.PulleyJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;
import rigibo.backend.setup.JointKind;
import rigibo.fuzz.chance.Chance;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** Draws joints of all kinds and their changes. */
record Connections(Chance chance, Temper temper) {

    /** Makes a joint between two bodies, and knows the Java expression for it. */
    private record Maker(String java, Making making) {}

    private interface Making {
        JointDefinition of(Stage stage, RigidBody a, RigidBody b);
    }

    /** Joins two bodies, which may be removed ones or one body twice. */
    Operation join(int a, int b) {
        Maker maker = maker(chance.oneOf(List.of(JointKind.values())), a, b);
        Stated<UnaryOperator<JointDefinition>> options = options();
        return Operation.tried(
                "pool.join(" + maker.java() + options.java() + ");",
                List.of(a, b),
                stage -> {
                    JointDefinition plain = maker.making().of(stage, stage.body(a), stage.body(b));
                    stage.pool().join(options.value().apply(plain));
                });
    }

    private Maker maker(JointKind kind, int a, int b) {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double toX = temper.placeX(chance);
        double toY = temper.placeY(chance);
        double axis = temper.angle(chance);
        double most = temper.factor(chance, 1e50);
        String two = "body[" + a + "], body[" + b + "], ";
        String at = two + Stated.numbers(x, y);
        return switch (kind) {
            case REVOLUTE ->
                    new Maker(
                            "RevoluteJoint.at(" + at + ")",
                            (stage, one, other) -> RevoluteJoint.at(one, other, x, y));
            case WELD ->
                    new Maker(
                            "WeldJoint.at(" + at + ")",
                            (stage, one, other) -> WeldJoint.at(one, other, x, y));
            case PRISMATIC ->
                    new Maker(
                            "PrismaticJoint.along(" + at + ", " + axis + ")",
                            (stage, one, other) -> PrismaticJoint.along(one, other, x, y, axis));
            case WHEEL ->
                    new Maker(
                            "WheelJoint.at(" + at + ", " + axis + ")",
                            (stage, one, other) -> WheelJoint.at(one, other, x, y, axis));
            case DISTANCE ->
                    new Maker(
                            "DistanceJoint.rod(body["
                                    + a
                                    + "], "
                                    + Stated.numbers(x, y)
                                    + ", body["
                                    + b
                                    + "], "
                                    + Stated.numbers(toX, toY)
                                    + ")",
                            (stage, one, other) -> DistanceJoint.rod(one, x, y, other, toX, toY));
            case MOTOR ->
                    new Maker(
                            "MotorJoint.friction(" + two + Stated.numbers(most, most) + ")",
                            (stage, one, other) -> MotorJoint.friction(one, other, most, most));
            case MOUSE ->
                    new Maker(
                            "MouseJoint.of(" + at + ")",
                            (stage, one, other) -> MouseJoint.of(one, other, x, y));
            case PULLEY ->
                    new Maker(
                            "PulleyJoint.over(" + two + toY + ")",
                            (stage, one, other) -> PulleyJoint.over(one, other, toY));
            case FILTER ->
                    new Maker(
                            "new FilterJoint(body[" + a + "], body[" + b + "])",
                            (stage, one, other) -> new FilterJoint(one, other));
            case GEAR -> gear(most);
        };
    }

    /** A gear of two existing joints; refused if there are none. */
    private Maker gear(double ratio) {
        int first = chance.whole(0, 20);
        int second = chance.whole(0, 20);
        return new Maker(
                "GearJoint.of(" + joint(first) + ", " + joint(second) + ", " + ratio + ")",
                (stage, one, two) ->
                        GearJoint.of(joint(stage, first), joint(stage, second), ratio));
    }

    private static String joint(int number) {
        return "pool.joints().get(" + number + " % pool.joints().size())";
    }

    private static Joint joint(Stage stage, int number) {
        List<Joint> joints = stage.pool().joints();
        if (joints.isEmpty()) {
            throw new IllegalStateException("there are no joints yet");
        }
        return joints.get(number % joints.size());
    }

    private Stated<UnaryOperator<JointDefinition>> options() {
        double low = -temper.length(chance);
        double high = chance.happens(0.1) ? low : temper.length(chance);
        double speed = temper.velocity(chance);
        double most = temper.factor(chance, 1e50);
        double hertz = chance.ofAnySize(0.1, 1e5);
        double ratio = chance.oneOf(0.0, 1.0, chance.between(0, 10));
        return switch (chance.whole(0, 7)) {
            case 0 -> option(call(".limits", low, high), j -> j.limits(low, high));
            case 1 -> option(call(".motor", speed, most), j -> j.motor(speed, most));
            case 2 -> option(call(".spring", hertz, ratio), j -> j.spring(hertz, ratio));
            case 3 -> option(".collideConnected(true)", j -> j.collideConnected(true));
            case 4 -> option(call(".breaking", most, most), j -> j.breaking(most, most));
            default -> option("", j -> j);
        };
    }

    private static Stated<UnaryOperator<JointDefinition>> option(
            String java, UnaryOperator<JointDefinition> option) {
        return new Stated<>(java, () -> option);
    }

    /** Changes or removes an existing joint. */
    Operation change() {
        double low = -temper.length(chance);
        double high = temper.length(chance);
        double speed = temper.velocity(chance);
        double most = temper.factor(chance, 1e50);
        double hertz = chance.ofAnySize(0.1, 1e5);
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        return switch (chance.whole(0, 6)) {
            case 0 -> verb(call("limits", low, high), joint -> joint.limits(low, high));
            case 1 -> verb(call("motor", speed, most), joint -> joint.motor(speed, most));
            case 2 -> verb(call("spring", hertz, 0.5), joint -> joint.spring(hertz, 0.5));
            case 3 -> verb(call("breaking", most, most), joint -> joint.breaking(most, most));
            case 4 -> verb(call("target", x, y), joint -> joint.target(x, y));
            case 5 -> verb(call("length", high), joint -> joint.length(high));
            default -> remove();
        };
    }

    private Operation verb(String call, Consumer<Joint> verb) {
        int number = chance.whole(0, 20);
        return Operation.tried(
                joint(number) + "." + call + ";",
                List.of(),
                stage -> verb.accept(joint(stage, number)));
    }

    private Operation remove() {
        int number = chance.whole(0, 20);
        return Operation.tried(
                "pool.remove(" + joint(number) + ");",
                List.of(),
                stage -> stage.pool().remove(joint(stage, number)));
    }
}

package rigibo.fuzz.program;

import static rigibo.fuzz.program.Stated.call;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.fuzz.chance.Chance;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** Draws calls that must be refused, with the field that the refusal names. */
record Refusals(Chance chance) {

    Operation draw(int body) {
        double bad = chance.notFinite();
        return switch (chance.whole(0, 5)) {
            case 0 -> ofBody(body, bad);
            case 1 -> beyondBounds(body);
            case 2 -> definition(bad);
            case 3 -> value(bad);
            case 4 -> ofPool(bad);
            default -> missing(body);
        };
    }

    private static Operation verb(int number, String field, String call, Consumer<RigidBody> verb) {
        return Operation.refused(
                "body[" + number + "]." + call + ";",
                field,
                List.of(number),
                stage -> verb.accept(stage.body(number)));
    }

    private static Operation pool(String field, String call, Consumer<Pool> verb) {
        return Operation.refused(
                "pool." + call + ";", field, List.of(), stage -> verb.accept(stage.pool()));
    }

    private static Operation alone(String field, String java, Runnable maker) {
        return Operation.refused(java + ";", field, List.of(), stage -> maker.run());
    }

    private Operation ofBody(int number, double bad) {
        return switch (chance.whole(0, 6)) {
            case 0 ->
                    verb(
                            number,
                            "RigidBody.moveTo",
                            call("moveTo", bad, 0, 0),
                            b -> b.moveTo(bad, 0, 0));
            case 1 ->
                    verb(
                            number,
                            "RigidBody.moveTo",
                            call("moveTo", 0, 0, bad),
                            b -> b.moveTo(0, 0, bad));
            case 2 ->
                    verb(
                            number,
                            "RigidBody.velocity",
                            call("velocity", 0, bad),
                            b -> b.velocity(0, bad));
            case 3 -> verb(number, "RigidBody.spin", call("spin", bad), b -> b.spin(bad));
            case 4 ->
                    verb(
                            number,
                            "RigidBody.applyForce",
                            call("applyForce", 1, bad, 0, 0),
                            b -> b.applyForce(1, bad, 0, 0));
            case 5 ->
                    verb(
                            number,
                            "RigidBody.applyTorque",
                            call("applyTorque", bad),
                            b -> b.applyTorque(bad));
            default ->
                    verb(
                            number,
                            "RigidBody.applyImpulse",
                            call("applyImpulse", 0, 0, bad, 0),
                            b -> b.applyImpulse(0, 0, bad, 0));
        };
    }

    private Operation beyondBounds(int number) {
        double fast = chance.ofEitherSign(1.001 * BodyDefinition.MOST_SPEED, Double.MAX_VALUE);
        double quick = chance.ofEitherSign(1.001 * BodyDefinition.MOST_SPIN, Double.MAX_VALUE);
        double turned = chance.ofEitherSign(1.001 * BodyDefinition.MOST_ANGLE, Double.MAX_VALUE);
        return switch (chance.whole(0, 2)) {
            case 0 ->
                    verb(
                            number,
                            "RigidBody.velocity",
                            call("velocity", fast, 0),
                            b -> b.velocity(fast, 0));
            case 1 -> verb(number, "RigidBody.spin", call("spin", quick), b -> b.spin(quick));
            default ->
                    verb(
                            number,
                            "RigidBody.moveTo",
                            call("moveTo", 0, 0, turned),
                            b -> b.moveTo(0, 0, turned));
        };
    }

    private Operation definition(double bad) {
        double notPositive = chance.oneOf(bad, 0.0, -0.0, -1.0, -Double.MIN_VALUE);
        return switch (chance.whole(0, 8)) {
            case 0 -> made("BodyDefinition.x", call("at", bad, 0), b -> b.at(bad, 0));
            case 1 -> made("BodyDefinition.angle", call("angle", bad), b -> b.angle(bad));
            case 2 ->
                    made(
                            "BodyDefinition.velocityY",
                            call("velocity", 0, bad),
                            b -> b.velocity(0, bad));
            case 3 -> made("BodyDefinition.spin", call("spin", bad), b -> b.spin(bad));
            case 4 ->
                    made(
                            "BodyDefinition.mass",
                            call("mass", notPositive),
                            b -> b.mass(notPositive));
            case 5 ->
                    made(
                            "BodyDefinition.inertia",
                            call("inertia", notPositive),
                            b -> b.inertia(notPositive));
            case 6 ->
                    made(
                            "BodyDefinition.gravityScale",
                            call("gravityScale", bad),
                            b -> b.gravityScale(bad));
            case 7 -> made("BodyDefinition.mass", "mass(1e101)", b -> b.mass(1e101));
            default -> made("BodyDefinition.name", "name(null)", b -> b.name(null));
        };
    }

    private static Operation made(
            String field, String call, UnaryOperator<BodyDefinition> stating) {
        return pool(
                field,
                "add(BodyDefinition.dynamic(new Circle(1))." + call + ")",
                p -> p.add(stating.apply(BodyDefinition.dynamic(new Circle(1)))));
    }

    private Operation value(double bad) {
        double less = chance.oneOf(bad, -1.0, -Double.MIN_VALUE);
        return switch (chance.whole(0, 9)) {
            case 0 -> alone("Circle.radius", call("new Circle", less), () -> new Circle(less));
            case 1 ->
                    alone("Polygon.box", call("Polygon.box", 1, less), () -> Polygon.box(1, less));
            case 2 ->
                    alone(
                            "Polygon.of",
                            call("Polygon.of", 0, 0, 1, 0, bad, 1),
                            () -> Polygon.of(0, 0, 1, 0, bad, 1));
            case 3 ->
                    alone(
                            "Polygon.of",
                            "Polygon.of(0, 0, 0, 1, 1, 0)",
                            () -> Polygon.of(0, 0, 0, 1, 1, 0));
            case 4 ->
                    alone(
                            "Material",
                            call("new Material", 1, less, 0),
                            () -> new Material(1, less, 0));
            case 5 ->
                    alone(
                            "Material.elasticity",
                            "new Material(1, 0, 1.5)",
                            () -> new Material(1, 0, 1.5));
            case 6 -> alone("Gravity", call("new Gravity", 0, bad), () -> new Gravity(0, bad));
            case 7 ->
                    alone(
                            "CentralForce.power",
                            "new CentralForce(0, 0, 1, 9)",
                            () -> new CentralForce(0, 0, 1, 9));
            case 8 -> effect(less);
            default ->
                    alone(
                            "Accuracy.substeps",
                            "Accuracy.GAME.withSubsteps(65)",
                            () -> Accuracy.GAME.withSubsteps(65));
        };
    }

    private Operation effect(double less) {
        return switch (chance.whole(0, 5)) {
            case 0 -> alone("AirDrag", call("new AirDrag", 1, less), () -> new AirDrag(1, less));
            case 1 -> alone("Wind", call("new Wind", 1e5, 0), () -> new Wind(1e5, 0));
            case 2 ->
                    alone(
                            "Buoyancy",
                            call("new Buoyancy", 0, less, 0),
                            () -> new Buoyancy(0, less, 0));
            case 3 -> alone("Sleep", call("new Sleep", less, 1), () -> new Sleep(less, 1));
            case 4 ->
                    alone(
                            "Friction needs Contacts",
                            "Effects.of(new Friction())",
                            () -> Effects.of(new Friction()));
            default ->
                    alone(
                            "Gravity twice",
                            "Effects.of(new Gravity(0, 0), new Gravity(0, 1))",
                            () -> Effects.of(new Gravity(0, 0), new Gravity(0, 1)));
        };
    }

    private Operation ofPool(double bad) {
        double dt = chance.oneOf(bad, 0.0, -1.0, 9e-10, 10.001, Double.MAX_VALUE);
        return switch (chance.whole(0, 5)) {
            case 0, 1 -> pool("Pool.step dt", call("step", dt), p -> p.step(dt));
            case 2 -> pool("Pool.bodyAt", call("bodyAt", bad, 0), p -> p.bodyAt(bad, 0));
            case 3 ->
                    pool(
                            "Pool.rayCast",
                            call("rayCast", 0, 0, bad, 0),
                            p -> p.rayCast(0, 0, bad, 0));
            case 4 ->
                    pool(
                            "Aabb",
                            "overlapping(new Aabb(1, 0, 0, 1), found -> {})",
                            p -> p.overlapping(new Aabb(1, 0, 0, 1), found -> {}));
            default ->
                    pool(
                            "another pool",
                            "remove(new Pool().add(BodyDefinition.dynamic(new Circle(1))))",
                            p -> p.remove(new Pool().add(BodyDefinition.dynamic(new Circle(1)))));
        };
    }

    /** Null arguments. */
    private Operation missing(int number) {
        return switch (chance.whole(0, 9)) {
            case 0 -> verb(number, "RigidBody.type", "type(null)", b -> b.type(null));
            case 1 -> verb(number, "RigidBody.shape", "shape(null)", b -> b.shape(null));
            case 2 -> verb(number, "RigidBody.material", "material(null)", b -> b.material(null));
            case 3 -> pool("Pool.effects", "effects(null)", p -> p.effects(null));
            case 4 -> pool("Pool.accuracy", "accuracy(null)", p -> p.accuracy(null));
            case 5 -> pool("Pool.add", "add(null)", p -> p.add(null));
            case 6 -> pool("body", "remove((RigidBody) null)", p -> p.remove((RigidBody) null));
            case 7 ->
                    pool(
                            "Pool.overlapping",
                            "overlapping(null, f -> {})",
                            p -> p.overlapping(null, f -> {}));
            case 8 -> alone("Pool.restore", "Pool.restore(null)", () -> Pool.restore(null));
            default ->
                    alone(
                            "Effects.of",
                            "Effects.of((Effect) null)",
                            () -> Effects.of((Effect) null));
        };
    }
}

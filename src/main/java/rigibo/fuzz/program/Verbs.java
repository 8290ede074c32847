package rigibo.fuzz.program;

import static rigibo.fuzz.program.Stated.call;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;
import rigibo.fuzz.chance.Chance;

import java.util.List;

/** Draws steps and edits of a pool. */
record Verbs(Chance chance, Temper temper, Bodies bodies) {

    /** A game's step, s. */
    private static final double USUAL_STEP = 1.0 / 60;

    Operation add(int number) {
        Stated<BodyDefinition> definition = bodies.definition(number);
        return Operation.tried(
                "body[" + number + "] = pool.add(" + definition.java() + ");",
                List.of(),
                stage -> stage.add(number, definition.value()));
    }

    Operation steps() {
        boolean isUsual = chance.happens(0.7);
        double dt = isUsual ? USUAL_STEP : chance.ofAnySize(Pool.SHORTEST_STEP, Pool.LONGEST_STEP);
        int count = isUsual ? chance.whole(1, 20) : chance.whole(1, 2);
        return Operation.done(
                "for (int i = 0; i < " + count + "; i++) { pool.step(" + dt + "); }",
                stage -> {
                    for (int i = 0; i < count; i++) {
                        stage.step(dt);
                    }
                });
    }

    Operation ofPool() {
        return switch (chance.whole(0, 2)) {
            case 0 -> {
                Stated<Effects> effects = DrawnEffects.draw(chance, temper);
                yield Operation.done(
                        "pool.effects(" + effects.java() + ");",
                        stage -> stage.pool().effects(effects.value()));
            }
            case 1 -> {
                Stated<Accuracy> accuracy = DrawnAccuracy.draw(chance);
                yield Operation.done(
                        "pool.accuracy(" + accuracy.java() + ");",
                        stage -> stage.pool().accuracy(accuracy.value()));
            }
            default ->
                    Operation.done(
                            "pool = Pool.restore(pool.snapshot(), pool.effects());"
                                    + " for (RigidBody b : pool.bodies())"
                                    + " { body[Integer.parseInt(b.name().substring(1))] = b; }",
                            Stage::goOnRestored);
        };
    }

    Operation ofBody(int number) {
        return switch (chance.whole(0, 9)) {
            case 0 -> moveTo(number);
            case 1, 2 -> velocity(number);
            case 3 -> force(number);
            case 4 -> impulse(number);
            case 5 -> type(number);
            case 6 -> shape(number);
            case 7 -> material(number);
            case 8 -> Operation.verb(number, "wake()", RigidBody::wake);
            default -> remove(number);
        };
    }

    private Operation moveTo(int number) {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double angle = temper.angle(chance);
        return Operation.verb(
                number, call("moveTo", x, y, angle), body -> body.moveTo(x, y, angle));
    }

    private Operation velocity(int number) {
        double vx = temper.velocity(chance);
        double vy = temper.velocity(chance);
        double spin = temper.spin(chance);
        return chance.happens(0.5)
                ? Operation.verb(number, call("velocity", vx, vy), body -> body.velocity(vx, vy))
                : Operation.verb(number, call("spin", spin), body -> body.spin(spin));
    }

    private Operation force(int number) {
        double fx = strength();
        double fy = strength();
        double px = temper.placeX(chance);
        double py = temper.placeY(chance);
        return chance.happens(0.6)
                ? Operation.verb(
                        number,
                        call("applyForce", fx, fy, px, py),
                        body -> body.applyForce(fx, fy, px, py))
                : Operation.verb(number, call("applyTorque", fx), body -> body.applyTorque(fx));
    }

    private Operation impulse(int number) {
        double jx = strength();
        double jy = strength();
        double px = temper.placeX(chance);
        double py = temper.placeY(chance);
        return Operation.verb(
                number,
                call("applyImpulse", jx, jy, px, py),
                body -> body.applyImpulse(jx, jy, px, py));
    }

    /** A force of the order of a body's weight, or of any size. */
    private double strength() {
        double mass = temper.size() * temper.size();
        double factor = temper.factor(chance, 1e150);
        return chance.happens(0.5) ? mass * factor : -mass * factor;
    }

    private Operation type(int number) {
        BodyType type = bodies.type();
        return Operation.verb(number, "type(BodyType." + type + ")", body -> body.type(type));
    }

    private Operation shape(int number) {
        Stated<Shape> shape = bodies.shape();
        return Operation.verb(
                number, "shape(" + shape.java() + ")", body -> body.shape(shape.value()));
    }

    private Operation material(int number) {
        Stated<Material> material = bodies.material();
        return Operation.verb(
                number,
                "material(" + material.java() + ")",
                body -> body.material(material.value()));
    }

    private Operation remove(int number) {
        return Operation.tried(
                "pool.remove(body[" + number + "]);",
                List.of(number),
                stage -> stage.pool().remove(stage.body(number)));
    }
}

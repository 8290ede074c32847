package rigibo.fuzz.program;

import static rigibo.fuzz.program.Stated.call;

import rigibo.backend.Explosion;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.fuzz.chance.Chance;

import java.util.List;

/** Draws other verbs of games: driving, putting to rest, locking, filtering. */
record EverydayVerbs(Chance chance, Temper temper, Bodies bodies) {

    /** The bound of drawn indices of parts; a body may have fewer parts. */
    private static final int MOST_PARTS = 3;

    Operation ofBody(int number) {
        return switch (chance.whole(0, 9)) {
            case 0, 1 -> driveTo(number);
            case 2 -> Operation.verb(number, "sleep()", RigidBody::sleep);
            case 3 -> Operation.verb(number, "disable()", RigidBody::disable);
            case 4, 5 -> Operation.verb(number, "enable()", RigidBody::enable);
            case 6 -> lock(number);
            case 7 -> filter(number);
            case 8 -> surface(number);
            default -> tag(number);
        };
    }

    /** Refused unless the body is kinematic and no lock keeps it from going there. */
    private Operation driveTo(int number) {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double angle = temper.angle(chance);
        double seconds = chance.ofAnySize(0.01, 10);
        return Operation.verb(
                number,
                call("driveTo", x, y, angle, seconds),
                body -> body.driveTo(x, y, angle, seconds));
    }

    private Operation lock(int number) {
        boolean isLocked = chance.happens(0.6);
        return switch (chance.whole(0, 2)) {
            case 0 -> Operation.verb(number, "xLocked(" + isLocked + ")", b -> b.xLocked(isLocked));
            case 1 -> Operation.verb(number, "yLocked(" + isLocked + ")", b -> b.yLocked(isLocked));
            default ->
                    Operation.verb(
                            number,
                            "rotationLocked(" + isLocked + ")",
                            b -> b.rotationLocked(isLocked));
        };
    }

    private Operation filter(int number) {
        Stated<Filter> filter = bodies.filter();
        int part = chance.whole(0, MOST_PARTS);
        return chance.happens(0.5)
                ? Operation.verb(
                        number, "filter(" + filter.java() + ")", b -> b.filter(filter.value()))
                : Operation.verb(
                        number,
                        "filter(" + part + ", " + filter.java() + ")",
                        b -> b.filter(part, filter.value()));
    }

    private Operation surface(int number) {
        Stated<Material> material = bodies.material();
        int part = chance.whole(0, MOST_PARTS);
        return Operation.verb(
                number,
                "material(" + part + ", " + material.java() + ")",
                b -> b.material(part, material.value()));
    }

    /** Tags are no verb of the engine: a removed body keeps its tag and accepts another. */
    private static Operation tag(int number) {
        return Operation.done(
                "if (body[" + number + "] != null) { body[" + number + "].tag(" + number + "); }",
                stage -> {
                    if (stage.knows(number)) {
                        stage.body(number).tag(number);
                    }
                });
    }

    /**
     * An explosion of either sign, whose impulse per metre is of the order of a weight per second,
     * or of any size.
     */
    Operation explode() {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double radius = chance.happens(0.2) ? 0 : temper.length(chance);
        double falloff = chance.happens(0.5) ? 0 : temper.length(chance);
        double strength = temper.size() * temper.factor(chance, 1e150);
        double impulse = chance.happens(0.8) ? strength : -strength;
        Stated<Filter> filter = bodies.filter();
        return Operation.tried(
                "pool.explode(new Explosion("
                        + Stated.numbers(x, y, radius, falloff, impulse)
                        + ", "
                        + filter.java()
                        + "));",
                List.of(),
                stage ->
                        stage.pool()
                                .explode(
                                        new Explosion(
                                                x, y, radius, falloff, impulse, filter.value())));
    }
}

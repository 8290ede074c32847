package rigibo.fuzz.program;

import static rigibo.fuzz.program.Stated.call;
import static rigibo.fuzz.program.Stated.numbers;

import rigibo.backend.Pool;
import rigibo.backend.RayHit;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Filter;
import rigibo.fuzz.chance.Chance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Draws queries with shapes, filters and sensors, which must not change anything. */
record ShapeQuestions(Chance chance, Temper temper, Bodies bodies) {

    Operation ask(int one, int other) {
        return switch (chance.whole(0, 4)) {
            case 0 -> rays();
            case 1 -> cast();
            case 2 -> overlapping();
            case 3 -> nearest();
            default -> sensors(one, other);
        };
    }

    /** The first of all bodies that a ray enters must be the body of the nearest hit. */
    private Operation rays() {
        double fromX = temper.placeX(chance);
        double fromY = temper.placeY(chance);
        double toX = temper.placeX(chance);
        double toY = temper.placeY(chance);
        Stated<Filter> filter = bodies.filter();
        String ray = numbers(fromX, fromY, toX, toY) + ", " + filter.java();
        return Operation.asked(
                "assertThat(pool.rayCastAll("
                        + ray
                        + ").stream().findFirst()).isEqualTo(pool.rayCast("
                        + ray
                        + "));",
                List.of(),
                stage -> {
                    Pool pool = stage.pool();
                    Filter whom = filter.value();
                    Optional<RayHit> all =
                            pool.rayCastAll(fromX, fromY, toX, toY, whom).stream().findFirst();
                    Optional<RayHit> first = pool.rayCast(fromX, fromY, toX, toY, whom);
                    if (!all.equals(first)) {
                        throw new AssertionError("of all " + all + ", alone " + first);
                    }
                });
    }

    private Stated<Placement> placement() {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double angle = temper.angle(chance);
        return new Stated<>(call("new Placement", x, y, angle), () -> new Placement(x, y, angle));
    }

    private Operation cast() {
        Stated<Shape> shape = bodies.newer(temper.length(chance));
        Stated<Placement> from = placement();
        double dx = chance.between(-1, 1) * temper.reach();
        double dy = chance.happens(0.1) ? 0 : chance.between(-1, 1) * temper.reach();
        Stated<Filter> filter = bodies.filter();
        return Operation.asked(
                "pool.cast("
                        + shape.java()
                        + ", "
                        + from.java()
                        + ", "
                        + numbers(dx, dy)
                        + ", "
                        + filter.java()
                        + ");",
                List.of(),
                stage -> stage.pool().cast(shape.value(), from.value(), dx, dy, filter.value()));
    }

    private Operation overlapping() {
        Stated<Shape> shape = bodies.newer(temper.length(chance));
        Stated<Placement> at = placement();
        Stated<Filter> filter = bodies.filter();
        return Operation.asked(
                "pool.overlapping("
                        + shape.java()
                        + ", "
                        + at.java()
                        + ", "
                        + filter.java()
                        + ", found -> {});",
                List.of(),
                stage -> {
                    List<RigidBody> found = new ArrayList<>();
                    stage.pool().overlapping(shape.value(), at.value(), filter.value(), found::add);
                    if (found.stream().distinct().count() != found.size()) {
                        throw new AssertionError("twice in " + found);
                    }
                });
    }

    private Operation nearest() {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double within = chance.happens(0.1) ? 0 : temper.length(chance);
        Stated<Filter> filter = bodies.filter();
        return Operation.asked(
                "pool.nearest(" + numbers(x, y, within) + ", " + filter.java() + ");",
                List.of(),
                stage -> stage.pool().nearest(x, y, within, filter.value()));
    }

    /** The pool and the sensor must name the same visitors; without the effect none are queried. */
    private static Operation sensors(int one, int other) {
        return Operation.asked(
                "if (pool.effects().declares(Sensors.class)) { assertThat(pool.inside(body["
                        + one
                        + "]).contains(body["
                        + other
                        + "])).isEqualTo(pool.isInside(body["
                        + one
                        + "], body["
                        + other
                        + "])); } else { pool.touching(body["
                        + one
                        + "], body["
                        + other
                        + "]); }",
                List.of(one, other),
                stage -> {
                    Pool pool = stage.pool();
                    RigidBody sensor = stage.body(one);
                    RigidBody visitor = stage.body(other);
                    if (!pool.effects().declares(Sensors.class)) {
                        pool.touching(sensor, visitor);
                    } else if (pool.inside(sensor).contains(visitor)
                            != pool.isInside(sensor, visitor)) {
                        throw new AssertionError(visitor + " is in and not in " + sensor);
                    }
                });
    }
}

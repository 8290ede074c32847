package rigibo.fuzz.program;

import static rigibo.fuzz.program.Stated.call;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;
import rigibo.fuzz.chance.Chance;

import java.util.ArrayList;
import java.util.List;

/** Draws queries, which must not change anything. */
record Questions(Chance chance, Temper temper) {

    Operation ask(int one, int other) {
        return switch (chance.whole(0, 7)) {
            case 0, 1 -> bodyAt();
            case 2, 3 -> rayCast();
            case 4, 5 -> overlapping();
            case 6 -> touching(one, other);
            default -> alteredSnapshot();
        };
    }

    private Operation bodyAt() {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        return Operation.asked(
                call("pool.bodyAt", x, y) + ";",
                List.of(),
                stage -> {
                    Pool pool = stage.pool();
                    stage.witness().foundAt(pool, x, y, pool.bodyAt(x, y));
                });
    }

    private Operation rayCast() {
        double fromX = temper.placeX(chance);
        double fromY = temper.placeY(chance);
        double toX = chance.happens(0.1) ? fromX : temper.placeX(chance);
        double toY = chance.happens(0.1) ? fromY : temper.placeY(chance);
        return Operation.asked(
                call("pool.rayCast", fromX, fromY, toX, toY) + ";",
                List.of(),
                stage -> {
                    Pool pool = stage.pool();
                    stage.witness()
                            .metByRay(
                                    pool,
                                    fromX,
                                    fromY,
                                    toX,
                                    toY,
                                    pool.rayCast(fromX, fromY, toX, toY));
                });
    }

    private Operation overlapping() {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double width = chance.happens(0.1) ? 0 : temper.length(chance);
        double height = chance.happens(0.1) ? 0 : temper.length(chance);
        return Operation.asked(
                "pool.overlapping("
                        + call("new Aabb", x, y, x + width, y + height)
                        + ", found -> {});",
                List.of(),
                stage -> {
                    Aabb box = new Aabb(x, y, x + width, y + height);
                    List<RigidBody> found = new ArrayList<>();
                    stage.pool().overlapping(box, found::add);
                    stage.witness().foundIn(stage.pool(), box, found);
                });
    }

    private static Operation touching(int one, int other) {
        return Operation.asked(
                "assertThat(pool.touching(body["
                        + one
                        + "], body["
                        + other
                        + "]))"
                        + ".isEqualTo(pool.touching(body["
                        + other
                        + "], body["
                        + one
                        + "]));",
                List.of(one, other),
                stage -> {
                    RigidBody a = stage.body(one);
                    RigidBody b = stage.body(other);
                    if (stage.pool().touching(a, b) != stage.pool().touching(b, a)) {
                        throw new AssertionError(a + " touches " + b + ", not the other way round");
                    }
                });
    }

    /** Altered bytes are refused, or they make a pool that can be stepped. */
    private Operation alteredSnapshot() {
        long seed = chance.bits();
        return Operation.asked(
                "Pool.restore(new Alteration(" + seed + "L).of(pool.snapshot()), pool.effects());",
                List.of(),
                stage -> restoreAltered(stage, new Alteration(seed)));
    }

    private static void restoreAltered(Stage stage, Alteration alteration) {
        byte[] bytes = alteration.of(stage.pool().snapshot());
        Pool pool;
        try {
            pool = stage.restored(bytes);
        } catch (IllegalArgumentException refused) {
            return;
        }
        stage.witness().restoredAltered(pool, bytes.length);
    }

    /** From here on a restored copy does the same. */
    Operation copy() {
        return new Operation(
                "Pool copy = Pool.restore(pool.snapshot(), pool.effects());",
                Operation.Kind.COPIED,
                "",
                List.of(),
                stage -> {});
    }
}

package rigibo.fuzz.program;

import rigibo.backend.effect.FieldFunction;
import rigibo.backend.effect.Gusts;
import rigibo.backend.geometry.Angle;
import rigibo.fuzz.chance.Chance;

/** Draws functions such as a caller might pass; some are not finite everywhere. */
final class Functions {

    private Functions() {}

    static Stated<Gusts> gusts(Chance chance, Temper temper) {
        double w = temper.factor(chance, 1e20);
        return switch (chance.whole(0, 3)) {
            case 0 ->
                    new Stated<>(
                            "time -> Angle.sin(" + w + " * time)",
                            () -> time -> Angle.sin(w * time));
            case 1 ->
                    new Stated<>(
                            "time -> time < " + w + " ? 1 : 0", () -> time -> time < w ? 1 : 0);
            case 2 -> new Stated<>("time -> " + w + " * time", () -> time -> w * time);
            default ->
                    new Stated<>(
                            "time -> time > " + w + " ? Double.NaN : 1",
                            () -> time -> time > w ? Double.NaN : 1);
        };
    }

    static Stated<FieldFunction> field(Chance chance, Temper temper) {
        double w = temper.factor(chance, 1e100);
        double limit = temper.placeX(chance);
        return switch (chance.whole(0, 4)) {
            case 0 ->
                    new Stated<>(
                            "point -> point.accelerate(" + -w + " * point.x, " + -w + " * point.y)",
                            () -> point -> point.accelerate(-w * point.x, -w * point.y));
            case 1 ->
                    new Stated<>(
                            "point -> point.accelerate(" + -w + " * point.y, " + w + " * point.x)",
                            () -> point -> point.accelerate(-w * point.y, w * point.x));
            case 2 ->
                    new Stated<>(
                            "point -> point.accelerate("
                                    + w
                                    + " * point.velocityY, "
                                    + -w
                                    + " * point.velocityX)",
                            () ->
                                    point ->
                                            point.accelerate(
                                                    w * point.velocityY, -w * point.velocityX));
            case 3 ->
                    new Stated<>(
                            "point -> point.push(" + w + " * Angle.sin(point.time), 0)",
                            () -> point -> point.push(w * Angle.sin(point.time), 0));
            default ->
                    new Stated<>(
                            "point -> point.push(point.x > " + limit + " ? Double.NaN : 1, 0)",
                            () -> point -> point.push(point.x > limit ? Double.NaN : 1, 0));
        };
    }
}

package rigibo.fuzz.program;

import static rigibo.fuzz.program.Stated.call;
import static rigibo.fuzz.program.Stated.numbers;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.fuzz.chance.Chance;

import java.util.Arrays;
import java.util.List;

/** Draws bodies and their shapes and materials. */
record Bodies(Chance chance, Temper temper) {

    /** A valid definition, unless its mass is out of range. */
    Stated<BodyDefinition> definition(int number) {
        Stated<BodyDefinition> body = ofType();
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        body = body.then(call("at", x, y), b -> b.at(x, y));
        double angle = temper.angle(chance);
        body = body.then(call("angle", angle), b -> b.angle(angle));
        Stated<Material> material = material();
        body = body.then("material(" + material.java() + ")", b -> b.material(material.value()));
        return options(body, number);
    }

    private Stated<BodyDefinition> ofType() {
        String maker =
                chance.oneOf("dynamic", "dynamic", "dynamic", "dynamic", "fixed", "kinematic");
        boolean isChain = !maker.equals("dynamic") && chance.happens(0.2);
        Stated<Shape> shape = isChain ? chain() : shape();
        Stated<BodyDefinition> body =
                new Stated<>(
                        "BodyDefinition." + maker + "(" + shape.java() + ")",
                        () ->
                                switch (maker) {
                                    case "fixed" -> BodyDefinition.fixed(shape.value());
                                    case "kinematic" -> BodyDefinition.kinematic(shape.value());
                                    default -> BodyDefinition.dynamic(shape.value());
                                });
        return maker.equals("fixed") ? body : moving(body);
    }

    private Stated<BodyDefinition> moving(Stated<BodyDefinition> body) {
        double vx = temper.velocity(chance);
        double vy = temper.velocity(chance);
        double spin = temper.spin(chance);
        return body.then(call("velocity", vx, vy), b -> b.velocity(vx, vy))
                .then(call("spin", spin), b -> b.spin(spin));
    }

    /** The bodies of a restored pool are identified by their names. */
    private Stated<BodyDefinition> options(Stated<BodyDefinition> plain, int number) {
        String name = Stage.name(number);
        Stated<BodyDefinition> body = plain.then("name(\"" + name + "\")", b -> b.name(name));
        if (chance.happens(0.1)) {
            double mass = temper.factor(chance, 1e90);
            body = body.then(call("mass", mass), b -> b.mass(mass));
        }
        if (chance.happens(0.1)) {
            double inertia = temper.factor(chance, 1e90);
            body = body.then(call("inertia", inertia), b -> b.inertia(inertia));
        }
        if (chance.happens(0.1)) {
            double scale = chance.oneOf(0.0, -1.0, 2.0, temper.factor(chance, 1e6));
            body = body.then(call("gravityScale", scale), b -> b.gravityScale(scale));
        }
        if (chance.happens(0.15)) {
            int group = chance.oneOf(1, 2, -1, Integer.MAX_VALUE, Integer.MIN_VALUE);
            body = body.then("group(" + group + ")", b -> b.group(group));
        }
        if (chance.happens(0.05)) {
            body = body.then("lockRotation()", BodyDefinition::lockRotation);
        }
        if (chance.happens(0.05)) {
            body = body.then("lockX()", BodyDefinition::lockX);
        }
        if (chance.happens(0.05)) {
            body = body.then("lockY()", BodyDefinition::lockY);
        }
        if (chance.happens(0.05)) {
            body = body.then("sensor()", BodyDefinition::sensor);
        }
        if (chance.happens(0.1)) {
            Stated<Filter> filter = filter();
            body = body.then("filter(" + filter.java() + ")", b -> b.filter(filter.value()));
        }
        return chance.happens(0.1) ? body.then("awake(false)", b -> b.awake(false)) : body;
    }

    /** Most bodies collide with all others; categories and groups are drawn. */
    Stated<Filter> filter() {
        if (chance.happens(0.5)) {
            return new Stated<>("Filter.ALL", () -> Filter.ALL);
        }
        int category = 1 << chance.whole(0, 3);
        int mask = chance.oneOf(~0, ~2, 3, 0);
        int group = chance.oneOf(0, 0, 1, -1);
        return new Stated<>(
                "new Filter(" + category + ", " + mask + ", " + group + ")",
                () -> new Filter(category, mask, group));
    }

    Stated<Shape> shape() {
        double width = temper.length(chance);
        return chance.happens(0.3) ? newer(width) : plain(width);
    }

    private Stated<Shape> plain(double width) {
        return switch (chance.whole(0, 4)) {
            case 0, 1 -> new Stated<>(call("new Circle", width / 2), () -> new Circle(width / 2));
            case 2 -> box(width, temper.length(chance));
            case 3 -> regular(chance.happens(0.05) ? 256 : chance.whole(3, 12), width / 2);
            default -> ragged(width / 2);
        };
    }

    /** Capsules, polygons with round corners, and compounds of two boxes or a box and a disc. */
    Stated<Shape> newer(double width) {
        double length = temper.length(chance);
        double round = 0.1 * Math.min(width, length);
        double aside = temper.length(chance);
        return switch (chance.whole(0, 4)) {
            case 0 ->
                    new Stated<>(
                            call("new Capsule", length / 2, width / 2),
                            () -> new Capsule(length / 2, width / 2));
            case 1 ->
                    new Stated<>(
                            call("Polygon.box", width, length) + call(".rounded", round),
                            () -> Polygon.box(width, length).rounded(round));
            case 2 ->
                    new Stated<>(
                            "Compound.of(Part.of("
                                    + call("Polygon.box", width, length)
                                    + "), Part.of("
                                    + call("Polygon.box", length, width)
                                    + ")"
                                    + call(".at", aside, 0)
                                    + ")",
                            () ->
                                    Compound.of(
                                            Part.of(Polygon.box(width, length)),
                                            Part.of(Polygon.box(length, width)).at(aside, 0)));
            case 3 ->
                    new Stated<>(
                            "Compound.of(Part.of("
                                    + call("new Circle", width)
                                    + "), Part.of("
                                    + call("new Circle", aside)
                                    + ").sensor())",
                            () ->
                                    Compound.of(
                                            Part.of(new Circle(width)),
                                            Part.of(new Circle(aside)).sensor()));
            default ->
                    new Stated<>(
                            "Compound.of(Part.of("
                                    + call("Polygon.box", width, length)
                                    + "), Part.of("
                                    + call("new Circle", width)
                                    + ")"
                                    + call(".at", 0, aside)
                                    + ")",
                            () ->
                                    Compound.of(
                                            Part.of(Polygon.box(width, length)),
                                            Part.of(new Circle(width)).at(0, aside)));
        };
    }

    /** A rough ground that runs from right to left, so that the matter is below, or a cave. */
    private Stated<Shape> chain() {
        return chance.happens(0.3) ? cave() : ground();
    }

    /** A chain clockwise around the scene or a part of it, so that the matter is outside. */
    private Stated<Shape> cave() {
        double[] xy = new double[2 * chance.whole(3, 24)];
        double reach = temper.reach() * chance.between(0.5, 2);
        for (int i = 0; i < xy.length; i += 2) {
            double around = -2 * Math.PI * i / xy.length;
            double rough = reach * chance.between(0.8, 1);
            xy[i] = rough * Angle.cos(around);
            xy[i + 1] = rough * Angle.sin(around);
        }
        return new Stated<>("Chain.loop(" + numbers(xy) + ")", () -> Chain.loop(xy));
    }

    private Stated<Shape> ground() {
        double[] xy = new double[2 * chance.whole(2, 20)];
        double edge = temper.length(chance);
        for (int i = 0; i < xy.length; i += 2) {
            xy[i] = -edge * i / 2;
            xy[i + 1] = edge * chance.between(-0.5, 0.5);
        }
        return new Stated<>("Chain.open(" + numbers(xy) + ")", () -> Chain.open(xy));
    }

    private Stated<Shape> box(double width, double height) {
        double flat = chance.happens(0.1) ? height / chance.ofAnySize(1, 1e3) : height;
        return new Stated<>(call("Polygon.box", width, flat), () -> Polygon.box(width, flat));
    }

    private static Stated<Shape> regular(int corners, double radius) {
        return new Stated<>(
                "Polygon.regular(" + corners + ", " + radius + ")",
                () -> Polygon.regular(corners, radius));
    }

    /** A polygon with corners anywhere on an ellipse, often with a very short edge. */
    private Stated<Shape> ragged(double radius) {
        double[] angles = new double[chance.whole(3, 8)];
        for (int i = 0; i < angles.length; i++) {
            angles[i] = chance.between(0, 2 * Math.PI);
        }
        Arrays.sort(angles);
        double[] xy = new double[2 * angles.length];
        double flatness = chance.ofAnySize(0.05, 1);
        double off = chance.happens(0.2) ? 1e3 * radius : 0;
        for (int i = 0; i < angles.length; i++) {
            xy[2 * i] = off + radius * Angle.cos(angles[i]);
            xy[2 * i + 1] = flatness * radius * Angle.sin(angles[i]);
        }
        return new Stated<>("Polygon.of(" + numbers(xy) + ")", () -> Polygon.of(xy));
    }

    Stated<Material> material() {
        double density = temper.factor(chance, 1e30);
        double friction = chance.oneOf(0.0, 0.03, 0.5, 1.2, temper.factor(chance, 1e200));
        double elasticity = chance.oneOf(0.0, 1.0, chance.between(0, 1));
        double rolling = seldom(temper.size() * temper.factor(chance, 1e100));
        double surface = seldom(temper.speed() * temper.factor(chance, 1e100));
        double drag = seldom(temper.factor(chance, 1e100));
        Stated<Material> material =
                new Stated<>(
                        call("new Material", density, friction, elasticity, rolling, surface, drag),
                        () -> new Material(density, friction, elasticity, rolling, surface, drag));
        double normal = chance.between(-1, 1);
        return chance.happens(0.1)
                ? material.then(call("oneWay", normal, 1), m -> m.oneWay(normal, 1))
                : material;
    }

    private double seldom(double number) {
        return chance.happens(0.3) ? number : 0;
    }

    BodyType type() {
        return chance.oneOf(List.of(BodyType.values()));
    }
}

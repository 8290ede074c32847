package rigibo.frontend.puzzle.level;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Angle;
import rigibo.backend.setup.Material;

import tools.jackson.databind.JsonNode;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;

/** Turns parts of a document that the schema accepts into records; degrees become radians. */
final class LevelReader {

    /** Without numbers for its water the effect is left out and reported by E140. */
    private static final String WATER = "buoyancy";

    private LevelReader() {}

    static Wording wording(JsonNode node) {
        Map<String, String> texts = new HashMap<>();
        for (Map.Entry<String, JsonNode> entry : node.properties()) {
            texts.put(entry.getKey(), entry.getValue().asString());
        }
        return new Wording(texts);
    }

    /**
     * The world.
     *
     * @throws IllegalArgumentException when an effect lacks another that it needs
     */
    static World world(JsonNode node) {
        List<Effect> effects = new ArrayList<>();
        for (JsonNode title : node.path("effects")) {
            if (!title.asString().equals(WATER) || node.has("water")) {
                effects.add(effect(title.asString(), node));
            }
        }
        return new World(
                node.path("width").asDouble(),
                node.path("height").asDouble(),
                Effects.of(effects.toArray(Effect[]::new)));
    }

    private static Effect effect(String title, JsonNode world) {
        return switch (title) {
            case "gravity" -> gravity(world.path("gravity"));
            case "contacts" -> new Contacts();
            case "rotation" -> new Rotation();
            case "friction" -> new Friction();
            case "restitution" -> new Restitution();
            case "rolling-resistance" -> new RollingResistance();
            case "surface-speed" -> new SurfaceSpeed();
            case "drag" -> new Drag();
            case WATER -> water(world.path("water"));
            case "thrust" -> new Thrust();
            // Their streams and pulls come from bodies, which are added in play.
            case "fan" -> new Fan();
            case "magnet" -> new Magnet();
            case "joints" -> new Joints();
            case "continuous-impacts" -> new ContinuousImpacts();
            case "sleep" -> new Sleep();
            default -> throw new IllegalArgumentException("no effect is called " + title);
        };
    }

    private static Gravity gravity(JsonNode node) {
        return new Gravity(node.path(0).asDouble(), node.path(1).asDouble());
    }

    private static Buoyancy water(JsonNode node) {
        return new Buoyancy(
                node.path("level").asDouble(),
                node.path("density").asDouble(World.USUAL_WATER),
                node.path("drag").asDouble(World.USUAL_DRAG));
    }

    static Limits limits(JsonNode node) {
        return new Limits(
                node.path("cooldown").asDouble(),
                node.path("hold").asDouble(),
                node.path("contactGrace").asDouble(Limits.USUAL_GRACE),
                node.path("par").asInt(),
                node.has("maxClicks")
                        ? OptionalInt.of(node.path("maxClicks").asInt())
                        : OptionalInt.empty(),
                node.has("timeLimit")
                        ? OptionalDouble.of(node.path("timeLimit").asDouble())
                        : OptionalDouble.empty());
    }

    static Ball ball(String name, JsonNode node) {
        return new Ball(
                name,
                node.path("x").asDouble(),
                node.path("y").asDouble(),
                node.path("radius").asDouble(),
                Substance.titled(node.path("material").asString(Substance.BALL.title())),
                motion(node));
    }

    static Platform platform(JsonNode node) {
        return new Platform(
                node.path("x").asDouble(),
                node.path("y").asDouble(),
                node.path("w").asDouble(),
                node.path("h").asDouble(Platform.USUAL_HEIGHT),
                Angle.ofDegrees(node.path("angle").asDouble(0)));
    }

    static LevelBody body(JsonNode node, Outline outline) {
        double angle = Angle.ofDegrees(node.path("angle").asDouble(0));
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        Substance substance = Substance.titled(node.path("material").asString());
        double x =
                node.path("x").asDouble() + cos * outline.centroidX() - sin * outline.centroidY();
        double y =
                node.path("y").asDouble() + sin * outline.centroidX() + cos * outline.centroidY();
        return new LevelBody(
                node.path("id").asString(),
                outline.shape(),
                x,
                y,
                angle,
                substance,
                material(node, substance.material()),
                motion(node),
                mobility(node),
                Handling.of(node),
                path(node, outline),
                Source.of(node, x, y, angle));
    }

    private static LevelBody.Mobility mobility(JsonNode node) {
        if (node.has("path")) {
            return LevelBody.Mobility.DRIVEN;
        }
        return node.path("dynamic").asBoolean(true)
                ? LevelBody.Mobility.DYNAMIC
                : LevelBody.Mobility.STATIC;
    }

    /**
     * The path of a body. A file states points for the body's own reference point, not its centre
     * of mass.
     */
    private static Optional<LevelPath> path(JsonNode body, Outline outline) {
        JsonNode path = body.path("path");
        if (path.isMissingNode()) {
            return Optional.empty();
        }
        double angle = Angle.ofDegrees(body.path("angle").asDouble(0));
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        double dx = cos * outline.centroidX() - sin * outline.centroidY();
        double dy = sin * outline.centroidX() + cos * outline.centroidY();
        List<LevelPath.Stop> stops = new ArrayList<>();
        for (JsonNode point : path.path("points")) {
            double x = point.path(0).asDouble() + dx;
            double y = point.path(1).asDouble() + dy;
            stops.add(new LevelPath.Stop(x, y));
        }
        String end = path.path("end").asString("back").toUpperCase(Locale.ROOT);
        return Optional.of(
                new LevelPath(
                        stops,
                        path.path("speed").asDouble(),
                        path.path("pause").asDouble(0),
                        LevelPath.End.valueOf(end)));
    }

    static Solution solution(JsonNode node) {
        List<Click> clicks = new ArrayList<>();
        for (JsonNode click : node.path("clicks")) {
            clicks.add(new Click(click.path("t").asDouble(), Click.targetIn(click)));
        }
        return new Solution(clicks);
    }

    private static Motion motion(JsonNode node) {
        return new Motion(
                node.path("vx").asDouble(0),
                node.path("vy").asDouble(0),
                node.path("spin").asDouble(0));
    }

    private static Material material(JsonNode node, Material usual) {
        Material plain = sidedAlike(node, usual);
        if (!node.has("oneWay")) {
            return plain;
        }
        double side = Angle.ofDegrees(node.path("oneWay").asDouble());
        return plain.oneWay(Angle.cos(side), Angle.sin(side));
    }

    private static Material sidedAlike(JsonNode node, Material usual) {
        return usual.density(node.path("density").asDouble(usual.density()))
                .friction(node.path("friction").asDouble(usual.friction()))
                .elasticity(node.path("restitution").asDouble(usual.elasticity()))
                .rollingResistance(
                        node.path("rollingResistance").asDouble(usual.rollingResistance()))
                .surfaceSpeed(node.path("surfaceSpeed").asDouble(usual.surfaceSpeed()))
                .drag(node.path("drag").asDouble(usual.drag()));
    }
}

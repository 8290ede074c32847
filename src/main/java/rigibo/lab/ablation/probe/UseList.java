package rigibo.lab.ablation.probe;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldPoint;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.List;
import java.util.function.UnaryOperator;

/** The uses of all effects. */
final class UseList {

    private static final Workload ROW = ProbeScenes.row();
    private static final Gravity EARTH = new Gravity(0, -9.81);
    private static final Effects WEIGHT = Effects.of(EARTH);
    private static final Effects TOUCHING = WEIGHT.with(new Contacts());
    private static final double HEAVY = 2;

    /** A stream and a magnet, m, that reach every body of a row. */
    private static final Fan.Jet WIND_TUNNEL = new Fan.Jet(0, -1e5, Math.PI / 2, 1e6, 1e6, 0);

    private static final Magnet.Pole LODESTONE = new Magnet.Pole(0, 0, 0, 1e6);

    private UseList() {}

    /** A use of each effect, in the order in which effects are listed. */
    static List<Use> all(long seed) {
        return List.of(
                row(Effects.of(), EARTH, "its gravity scale is 1, not 0")
                        .idler(body -> body.gravityScale(0)),
                onPlates(
                        WEIGHT, new Contacts(), "it rests on a plate, instead of falling", 0, 0.31),
                row(WEIGHT, new Rotation(), "it turns").user(body -> body.spin(3)),
                inScene(ProbeScenes.friction(), new Friction(), "its friction is not 0")
                        .idler(matter(material -> material.friction(0))),
                inScene(ProbeScenes.flood(seed), new Restitution(), "its elasticity is 0.5, not 0")
                        .idler(matter(material -> material.elasticity(0))),
                inScene(
                                ProbeScenes.wheel(),
                                new RollingResistance(),
                                "its rolling lever is 5 mm, not 0; that of the ramps is 0")
                        .idler(matter(material -> material.rollingResistance(0))),
                inScene(ProbeScenes.friction(), new SurfaceSpeed(), "its outline runs at 1 m/s")
                        .user(matter(material -> material.surfaceSpeed(1))),
                row(WEIGHT, new Drag(), "its drag is 0.5 /s, not 0")
                        .user(matter(material -> material.drag(0.5))),
                row(Effects.of(), new AirDrag(1.2, 1.1), "it moves")
                        .user(body -> body.velocity(0, 5)),
                row(WEIGHT.with(new Drag()), new Wind(3, 1), "its drag is 0.5 /s, not 0")
                        .user(matter(material -> material.drag(0.5))),
                row(WEIGHT, new Field(UseList::pushHeavy), "the function adds a force to it")
                        .user(body -> body.mass(HEAVY))
                        .idler(body -> body.mass(1)),
                row(
                                WEIGHT,
                                new CentralForce(0, 0, 1e-3, 1),
                                "it acts on every body; neutral at the strength 0")
                        .neutral(new CentralForce(0, 0, 0, 1)),
                row(
                                WEIGHT,
                                new Fan(WIND_TUNNEL.force(1e-3)),
                                "its one stream is wide enough for all; neutral at the force 0")
                        .neutral(new Fan(WIND_TUNNEL.force(0))),
                row(
                                WEIGHT,
                                new Magnet(LODESTONE.strength(1e-3)),
                                "its one magnet reaches all; neutral at the strength 0")
                        .neutral(new Magnet(LODESTONE.strength(0))),
                row(WEIGHT, new Buoyancy(-500, 2, 1), "it is under water")
                        .user(body -> body.at(body.x(), -1000)),
                row(WEIGHT, new Thrust(), "a force is asked for before each step")
                        .push(body -> body.applyForce(1, 2, body.x(), body.y())),
                row(TOUCHING, new Sensors(), "it is inside of a sensor that flies along")
                        .users(body -> List.of(body, along(body, 0.5, 0).sensor())),
                row(TOUCHING, new Joints(), "a rod holds it to a body that flies along")
                        .users(body -> List.of(body.group(1), along(body, 0.1, 0.3).group(1))),
                onPlates(
                        TOUCHING.with(new Restitution()),
                        new ContinuousImpacts(),
                        "it bounces on a plate, instead of falling",
                        0.9,
                        1),
                onPlates(
                        TOUCHING,
                        new Sleep(),
                        "it rests on a plate and falls asleep, instead of falling",
                        0,
                        0.31));
    }

    private static UnaryOperator<BodyDefinition> matter(UnaryOperator<Material> change) {
        return body -> body.material(change.apply(body.material()));
    }

    private static void pushHeavy(FieldPoint at) {
        if (at.mass >= HEAVY) {
            at.push(-at.velocityY, at.velocityX);
        }
    }

    private static Use row(Effects base, Effect effect, String words) {
        return Use.of(ROW, base, effect, words);
    }

    /** A use in a scene of the table, whose other effects are declared beside it. */
    private static Use inScene(Workload scene, Effect effect, String words) {
        return Use.of(scene, scene.effects().without(effect.getClass()), effect, words);
    }

    /** A disc that flies along with a body, at a height above it, m. */
    private static BodyDefinition along(BodyDefinition body, double radius, double above) {
        return BodyDefinition.dynamic(new Circle(radius))
                .mass(1)
                .at(body.x(), body.y() + above)
                .velocity(body.velocityX(), body.velocityY());
    }

    /** A use whose users rest on a plate, whose surface is at a distance below their centre, m. */
    private static Use onPlates(
            Effects base, Effect effect, String words, double elasticity, double height) {
        Material matter = new Material(1, 0, elasticity);
        BodyDefinition plate = BodyDefinition.fixed(Polygon.box(1, 1)).material(matter);
        return row(base, effect, words)
                .users(
                        body ->
                                List.of(
                                        body.material(matter),
                                        plate.at(body.x(), body.y() - height - 0.5)))
                .idler(body -> body.material(matter));
    }
}

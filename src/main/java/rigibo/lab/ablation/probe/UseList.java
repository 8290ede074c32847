package rigibo.lab.ablation.probe;

import rigibo.backend.RigidBody;
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
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/** Every effect in the one scene that suits it. */
final class UseList {

    private static final List<Share> EVERY_SHARE = List.of(Share.values());

    /** For an effect that acts on all bodies or does nothing. */
    private static final List<Share> NONE_OR_ALL = List.of(Share.NONE, Share.ALL);

    private static final Workload ROW = new FlyersInARow();
    private static final Gravity EARTH = new Gravity(0, -9.81);
    private static final Effects WEIGHT = Effects.of(EARTH);
    private static final double HEAVY = 2;

    /** A stream and a magnet, m, that reach every body of a row. */
    private static final Fan.Jet WIND_TUNNEL = new Fan.Jet(0, -1e5, Math.PI / 2, 1e6, 1e6, 0);

    private static final Magnet.Pole LODESTONE = new Magnet.Pole(0, 0, 0, 1e6);

    private UseList() {}

    /** A use each, in the order effects are listed. */
    static List<Use> all(long seed) {
        return List.of(
                row(
                        Effects.of(),
                        EARTH,
                        "its gravity scale is 1, not 0",
                        same(),
                        body -> body.gravityScale(0)),
                onPlates(
                        WEIGHT, new Contacts(), "it rests on a plate, instead of falling", 0, 0.31),
                row(
                        WEIGHT,
                        new Rotation(),
                        "it turns",
                        body -> body.spin(3),
                        UnaryOperator.identity()),
                inScene(
                        new FrictionLanes(),
                        new Friction(),
                        "its friction is not 0",
                        same(),
                        matter(material -> material.friction(0))),
                inScene(
                        new Flood(seed),
                        new Restitution(),
                        "its elasticity is 0.5, not 0",
                        same(),
                        matter(material -> material.elasticity(0))),
                inScene(
                        new Wheel(),
                        new RollingResistance(),
                        "its rolling lever is 5 mm, not 0; that of the ramps is 0",
                        same(),
                        matter(material -> material.rollingResistance(0))),
                inScene(
                        new FrictionLanes(),
                        new SurfaceSpeed(),
                        "its outline runs at 1 m/s",
                        matter(material -> material.surfaceSpeed(1)),
                        same()),
                row(
                        WEIGHT,
                        new Drag(),
                        "its drag is 0.5 /s, not 0",
                        matter(material -> material.drag(0.5)),
                        same()),
                row(
                        Effects.of(),
                        new AirDrag(1.2, 1.1),
                        "it moves",
                        body -> body.velocity(0, 5),
                        same()),
                row(
                        WEIGHT.with(new Drag()),
                        new Wind(3, 1),
                        "its drag is 0.5 /s, not 0",
                        matter(material -> material.drag(0.5)),
                        same()),
                row(
                        WEIGHT,
                        new Field(UseList::pushHeavy),
                        "the function adds a force to it",
                        body -> body.mass(HEAVY),
                        body -> body.mass(1)),
                centralForce(),
                fan(),
                magnet(),
                row(
                        WEIGHT,
                        new Buoyancy(-500, 2, 1),
                        "it is under water",
                        body -> body.at(body.x(), -1000),
                        same()),
                thrust(),
                sensors(),
                joints(),
                onPlates(
                        WEIGHT.with(new Contacts()).with(new Restitution()),
                        new ContinuousImpacts(),
                        "it bounces on a plate, instead of falling",
                        0.9,
                        1),
                onPlates(
                        WEIGHT.with(new Contacts()),
                        new Sleep(),
                        "it rests on a plate and falls asleep, instead of falling",
                        0,
                        0.31));
    }

    private static UnaryOperator<BodyDefinition> same() {
        return UnaryOperator.identity();
    }

    private static UnaryOperator<BodyDefinition> matter(UnaryOperator<Material> change) {
        return body -> body.material(change.apply(body.material()));
    }

    private static Function<BodyDefinition, List<BodyDefinition>> alone(
            UnaryOperator<BodyDefinition> change) {
        return body -> List.of(change.apply(body));
    }

    private static void pushHeavy(FieldPoint at) {
        if (at.mass >= HEAVY) {
            at.push(-at.velocityY, at.velocityX);
        }
    }

    private static Use row(
            Effects base,
            Effect effect,
            String words,
            UnaryOperator<BodyDefinition> user,
            UnaryOperator<BodyDefinition> idler) {
        return in(ROW, base, effect, words, user, idler);
    }

    /** In a scene of the table, whose other effects are declared beside it. */
    private static Use inScene(
            Workload scene,
            Effect effect,
            String words,
            UnaryOperator<BodyDefinition> user,
            UnaryOperator<BodyDefinition> idler) {
        Effects base = scene.effects().without(effect.getClass());
        return in(scene, base, effect, words, user, idler);
    }

    private static Use in(
            Workload scene,
            Effects base,
            Effect effect,
            String words,
            UnaryOperator<BodyDefinition> user,
            UnaryOperator<BodyDefinition> idler) {
        return new Use(
                scene,
                base,
                share -> effect,
                words,
                alone(user),
                alone(idler),
                Use.NO_PUSH,
                EVERY_SHARE);
    }

    private static Use centralForce() {
        return new Use(
                ROW,
                WEIGHT,
                share -> new CentralForce(0, 0, share == Share.NONE ? 0 : 1e-3, 1),
                "it acts on every body; neutral at the strength 0",
                alone(same()),
                alone(same()),
                Use.NO_PUSH,
                NONE_OR_ALL);
    }

    private static Use fan() {
        return new Use(
                ROW,
                WEIGHT,
                share -> new Fan(WIND_TUNNEL.force(share == Share.NONE ? 0 : 1e-3)),
                "its one stream is wide enough for all; neutral at the force 0",
                alone(same()),
                alone(same()),
                Use.NO_PUSH,
                NONE_OR_ALL);
    }

    private static Use magnet() {
        return new Use(
                ROW,
                WEIGHT,
                share -> new Magnet(LODESTONE.strength(share == Share.NONE ? 0 : 1e-3)),
                "its one magnet reaches all; neutral at the strength 0",
                alone(same()),
                alone(same()),
                Use.NO_PUSH,
                NONE_OR_ALL);
    }

    private static Use thrust() {
        Consumer<RigidBody> push = body -> body.applyForce(1, 2, body.x(), body.y());
        return new Use(
                ROW,
                WEIGHT,
                share -> new Thrust(),
                "a force is asked for before each step",
                alone(same()),
                alone(same()),
                push,
                EVERY_SHARE);
    }

    /** Users are inside of a sensor that is thrown along with them. */
    private static Use sensors() {
        UnaryOperator<BodyDefinition> along =
                body ->
                        BodyDefinition.dynamic(new Circle(0.5))
                                .mass(1)
                                .at(body.x(), body.y())
                                .velocity(body.velocityX(), body.velocityY())
                                .sensor();
        return new Use(
                ROW,
                WEIGHT.with(new Contacts()),
                share -> new Sensors(),
                "it is inside of a sensor that flies along",
                body -> List.of(body, along.apply(body)),
                alone(same()),
                Use.NO_PUSH,
                EVERY_SHARE);
    }

    /** Users have a partner that flies along, and where joints are declared a rod between them. */
    private static Use joints() {
        UnaryOperator<BodyDefinition> beside =
                body ->
                        BodyDefinition.dynamic(new Circle(0.1))
                                .mass(1)
                                .at(body.x(), body.y() + UsedScene.ROD)
                                .velocity(body.velocityX(), body.velocityY())
                                .group(1);
        return new Use(
                ROW,
                WEIGHT.with(new Contacts()),
                share -> new Joints(),
                "a rod holds it to a body that flies along",
                body -> List.of(body.group(1), beside.apply(body)),
                alone(same()),
                Use.NO_PUSH,
                EVERY_SHARE);
    }

    /** Users have a plate under them, whose surface is so many metres below their centre. */
    private static Use onPlates(
            Effects base, Effect effect, String words, double elasticity, double height) {
        Material matter = new Material(1, 0, elasticity);
        Function<BodyDefinition, List<BodyDefinition>> user =
                body ->
                        List.of(
                                body.material(matter),
                                BodyDefinition.fixed(Polygon.box(1, 1))
                                        .at(body.x(), body.y() - height - 0.5)
                                        .material(matter));
        return new Use(
                ROW,
                base,
                share -> effect,
                words,
                user,
                alone(body -> body.material(matter)),
                Use.NO_PUSH,
                EVERY_SHARE);
    }
}

package rigibo.backend.law;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldPoint;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Correction;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.Integrator;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/**
 * Bodies, effects and knobs drawn from the ends of their ranges, with strangers so far away that
 * nothing a body can do within some steps reaches them.
 */
final class HostileScene {

    /**
     * m: beyond the way at the highest speed accepted, and that of a corner at the highest spin.
     */
    private static final double FAR = 1e13;

    /** Size of a stranger, m: large enough for the resolution of doubles out there. */
    private static final double LARGE = 1e4;

    private static final List<Double> WILD =
            List.of(
                    Double.NaN,
                    Double.POSITIVE_INFINITY,
                    Double.NEGATIVE_INFINITY,
                    1e300,
                    1e200,
                    1e100,
                    1e15);

    final Effects effects;
    final Accuracy accuracy;
    private final List<BodyDefinition> sick = new ArrayList<>();
    private final Draw draw;

    HostileScene(long seed) {
        draw = new Draw(seed);
        effects = Effects.of(effects().toArray(Effect[]::new));
        accuracy = accuracy();
        if (draw.chance(0.7)) {
            sick.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5).material(material()));
        }
        for (int i = draw.whole(1, 8); i > 0; i--) {
            sick.add(body());
        }
    }

    private List<Effect> effects() {
        List<Effect> list = new ArrayList<>(List.of(new Contacts()));
        list.add(new Gravity(0, draw.chance(0.5) ? -9.81 : -draw.ofAnySize(1e-6, 1e6)));
        addByChance(list, 0.5, new Thrust(), new Sleep());
        addByChance(list, 0.8, new Restitution(), new ContinuousImpacts());
        if (draw.chance(0.8)) {
            list.add(new Rotation());
            addByChance(list, 0.3, new RollingResistance());
        }
        if (draw.chance(0.8)) {
            list.add(new Friction());
            addByChance(list, 0.3, new SurfaceSpeed());
        }
        if (draw.chance(0.4)) {
            double density = draw.chance(0.4) ? 1.2 : draw.ofAnySize(1e-300, 1e300);
            list.add(new AirDrag(density, draw.ofAnySize(1e-3, 1e3)));
            double gust = draw.oneOf(WILD);
            double rises = draw.between(0, 5);
            addByChance(list, 0.3, new Wind(1e3, -1e4, time -> time > rises ? gust : 1));
        }
        if (draw.chance(0.3)) {
            list.add(new Drag());
        }
        if (draw.chance(0.3)) {
            list.add(new CentralForce(0, 0, draw.ofAnySize(1e-300, 1e300), draw.between(-8, 8)));
        }
        if (draw.chance(0.3)) {
            list.add(field());
        }
        return list;
    }

    private void addByChance(List<Effect> list, double probability, Effect... effects) {
        for (Effect effect : effects) {
            if (draw.chance(probability)) {
                list.add(effect);
            }
        }
    }

    /** A function that answers wildly for some of the bodies, none of which is a stranger. */
    private Field field() {
        double wild = draw.oneOf(WILD);
        double threshold = draw.ofAnySize(1e-3, 1e3);
        boolean isBySpeed = draw.chance(0.5);
        return new Field(
                point -> {
                    if (point.x < FAR / 2 && asked(point, isBySpeed) > threshold) {
                        point.accelerate(wild, -wild);
                    }
                });
    }

    private static double asked(FieldPoint point, boolean isBySpeed) {
        return isBySpeed ? -point.velocityY : point.mass;
    }

    private Accuracy accuracy() {
        Accuracy preset = draw.oneOf(List.of(Preset.values())).accuracy;
        if (draw.chance(0.3)) {
            return preset;
        }
        return preset.withIntegrator(draw.oneOf(List.of(Integrator.values())))
                .withImpacts(draw.oneOf(List.of(ImpactMode.values())))
                .withContactSolver(draw.oneOf(List.of(ContactSolver.values())))
                .withCorrection(draw.oneOf(List.of(Correction.values())))
                .withMaxImpactsPerPair(draw.whole(4, 64));
    }

    private double signed(double least, double most) {
        return (draw.chance(0.5) ? 1 : -1) * draw.ofAnySize(least, most);
    }

    private Material material() {
        double friction = draw.chance(0.6) ? draw.between(0, 1.2) : anyUpTo(Material.MOST_FRICTION);
        double drag = draw.chance(0.5) ? 0 : anyUpTo(Material.MOST_DRAG);
        double rolling = draw.chance(0.5) ? 0 : anyUpTo(Material.MOST_ROLLING_RESISTANCE);
        double running = draw.chance(0.5) ? 0 : signed(1e-9, BodyDefinition.MOST_SPEED);
        double density = draw.chance(0.5) ? 1 : draw.ofAnySize(1e-20, 1e20);
        return new Material(density, friction, draw.between(0, 1), rolling, running, drag);
    }

    /** The most itself now and then. */
    private double anyUpTo(double most) {
        return draw.chance(0.2) ? most : draw.ofAnySize(1e-9, most);
    }

    private BodyDefinition body() {
        double radius = draw.chance(0.7) ? draw.between(0.2, 1) : draw.ofAnySize(1e-6, 1e2);
        BodyDefinition body =
                switch (draw.whole(0, 9)) {
                    case 0 -> BodyDefinition.fixed(draw.shape(radius));
                    case 1 -> inMotion(BodyDefinition.kinematic(draw.shape(radius)));
                    default -> weighed(inMotion(BodyDefinition.dynamic(draw.shape(radius))));
                };
        double x = draw.chance(0.1) ? -draw.ofAnySize(1, 1e300) : draw.between(-3, 3);
        double y = draw.chance(0.1) ? signed(1, 1e300) : draw.between(0, 4);
        return body.at(x, y).angle(draw.between(-4, 4)).material(material());
    }

    private BodyDefinition inMotion(BodyDefinition body) {
        double fastest = BodyDefinition.MOST_SPEED;
        return body.velocity(speedUpTo(fastest), speedUpTo(fastest))
                .spin(speedUpTo(BodyDefinition.MOST_SPIN));
    }

    private double speedUpTo(double most) {
        return draw.chance(0.7) ? draw.between(-5, 5) : signed(1, most);
    }

    private BodyDefinition weighed(BodyDefinition body) {
        double least = BodyDefinition.LEAST_MASS;
        double most = BodyDefinition.MOST_MASS;
        BodyDefinition heavy = body;
        if (draw.chance(0.4)) {
            heavy = body.mass(draw.ofAnySize(least, most)).inertia(draw.ofAnySize(least, most));
        }
        return draw.chance(0.2) ? heavy.gravityScale(signed(1e-9, 1e6)) : heavy;
    }

    /** Strangers alone: a box on a floor and a disc that falls on both. */
    Pool healthy() {
        Pool pool = new Pool(effects, accuracy);
        pool.add(BodyDefinition.fixed(Polygon.box(20 * LARGE, LARGE)).at(FAR, -LARGE / 2));
        pool.add(BodyDefinition.dynamic(Polygon.box(LARGE, LARGE)).at(FAR, LARGE / 2));
        pool.add(
                BodyDefinition.dynamic(new Circle(LARGE / 2))
                        .at(FAR + LARGE / 4, 2 * LARGE)
                        .velocity(0, -LARGE));
        return pool;
    }

    /** A pool with the bodies of {@link #healthy}, then the sick. */
    Pool withSick() {
        Pool pool = healthy();
        sick.forEach(pool::add);
        return pool;
    }

    /** Another step's length, s: a game's, or any that a pool accepts. */
    double length() {
        double shortest = Pool.SHORTEST_STEP;
        double longest = Pool.LONGEST_STEP;
        double any = draw.chance(0.2) ? longest : draw.ofAnySize(shortest, longest);
        return draw.chance(0.5) ? 1.0 / 60 : any;
    }

    /** Forces without measure on some of the sick, where forces may be asked for. */
    void push(Pool pool) {
        for (RigidBody body : pool.bodies()) {
            if (effects.declares(Thrust.class) && body.x() < FAR / 2 && draw.chance(0.3)) {
                body.applyForce(signed(1e-3, 1e300), signed(1e-3, 1e300), body.x(), body.y());
                body.applyTorque(signed(1e-3, 1e300));
            }
        }
    }
}

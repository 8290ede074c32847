package rigibo.backend.law;

import rigibo.backend.effect.Joints;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;

/** Joins bodies of a scene, one to the next, and a few to what stands, by joints of all kinds. */
final class Links {

    /** Seeds of joints begin here, apart from those of bodies. */
    private static final long SEEDS = 1_000_000;

    /** Probabilities of a joint between neighbours, and between a body and a static one. */
    private static final double JOINED = 0.7;

    private static final double HUNG = 0.15;

    /** What holds on to places in the world, of which whoever passes by sees others. */
    private static final Set<JointKind> WORLDLY = EnumSet.of(JointKind.MOUSE, JointKind.PULLEY);

    private final Draw draw;
    private final List<JointKind> kinds;

    private Links(long seed, List<JointKind> kinds) {
        draw = new Draw(seed + SEEDS);
        this.kinds = kinds;
    }

    /** Joints of all kinds without motors, so that energy can only decrease. */
    static RandomScene on(RandomScene scene) {
        return new Links(scene.seed(), List.of(JointKind.values())).join(scene);
    }

    /** Joints of all kinds that do not depend on a place in the world. */
    static RandomScene carriedAlongOn(RandomScene scene) {
        List<JointKind> kinds = new ArrayList<>(List.of(JointKind.values()));
        kinds.removeAll(WORLDLY);
        return new Links(scene.seed(), kinds).join(scene);
    }

    private RandomScene join(RandomScene scene) {
        List<Link> links = new ArrayList<>();
        List<BodyDefinition> bodies = scene.bodies();
        for (int i = 0; i < bodies.size(); i++) {
            if (bodies.get(i).type() != BodyType.DYNAMIC) {
                continue;
            }
            if (i + 1 < bodies.size() && draw.chance(JOINED)) {
                links.add(link(bodies.get(i), bodies.get(i + 1), bodies.get(0)));
            }
            if (bodies.get(0).type() == BodyType.STATIC && draw.chance(HUNG)) {
                links.add(hung(bodies.get(0), bodies.get(i)));
            }
        }
        return scene.links(links).effects(scene.effects().with(new Joints()));
    }

    private Link link(BodyDefinition a, BodyDefinition b, BodyDefinition first) {
        JointKind kind = draw.oneOf(kinds);
        boolean isCarried = first != a && first != b;
        return between(kind == JointKind.GEAR && !isCarried ? JointKind.WELD : kind, a, b, first);
    }

    private Link hung(BodyDefinition ground, BodyDefinition body) {
        JointKind kind = draw.oneOf(kinds);
        boolean needsTwo = kind == JointKind.GEAR || kind == JointKind.PULLEY;
        return between(needsTwo ? JointKind.REVOLUTE : kind, ground, body, ground);
    }

    private Link between(
            JointKind kind, BodyDefinition a, BodyDefinition b, BodyDefinition carrier) {
        boolean isHung = a.type() != BodyType.DYNAMIC;
        double share = draw.between(0.2, 0.8);
        double x = isHung ? b.x() + draw.between(-1, 1) : a.x() + share * (b.x() - a.x());
        double y = isHung ? b.y() + draw.between(0.2, 1) : a.y() + share * (b.y() - a.y());
        boolean isPulled = kind == JointKind.PULLEY || kind == JointKind.MOUSE;
        return new Link(
                kind,
                kind == JointKind.GEAR ? List.of(a, b, carrier) : List.of(a, b),
                kind == JointKind.DISTANCE && !isHung ? a.x() : x,
                kind == JointKind.DISTANCE && !isHung ? a.y() : y,
                draw.between(-3, 3),
                isPulled ? x + draw.between(-0.5, 0.5) : b.x(),
                isPulled ? y + draw.between(1, 3) : b.y(),
                kind == JointKind.MOUSE ? Double.POSITIVE_INFINITY : draw.ofAnySize(0.1, 10),
                draw.ofAnySize(0.1, 10),
                settings(kind));
    }

    private JointSettings settings(JointKind kind) {
        if (kind == JointKind.FILTER) {
            return JointSettings.NONE;
        }
        JointSettings plain = JointSettings.NONE.collideConnected(draw.chance(0.3));
        // A joint that let bodies overlap would leave them to be pushed apart.
        if (plain.collideConnected() && draw.chance(0.3)) {
            plain = plain.breaking(draw.ofAnySize(10, 1000), draw.ofAnySize(10, 1000));
        }
        return switch (kind) {
            case REVOLUTE, PRISMATIC, WHEEL -> limited(sprung(plain, 0.3));
            case DISTANCE -> sprung(plain, 0.4);
            case WELD -> sprung(plain, 0.3);
            case MOUSE -> plain.spring(new JointSpring(draw.between(0.5, 5), draw.between(0, 1)));
            case MOTOR, PULLEY, GEAR, FILTER -> plain;
        };
    }

    private JointSettings sprung(JointSettings plain, double chance) {
        return draw.chance(chance)
                ? plain.spring(new JointSpring(draw.ofAnySize(0.5, 20), draw.between(0, 1)))
                : plain;
    }

    private JointSettings limited(JointSettings plain) {
        JointSettings braked =
                draw.chance(0.3) ? plain.motor(new JointMotor(0, draw.ofAnySize(0.01, 10))) : plain;
        return draw.chance(0.4)
                ? braked.limits(
                        new JointLimits(
                                -draw.between(0, 0.5),
                                draw.between(0, 0.5),
                                draw.chance(0.5) ? draw.between(0, 1) : 0))
                : braked;
    }
}

package rigibo.backend.law;

import rigibo.backend.DistanceJoint;
import rigibo.backend.FilterJoint;
import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.MotorJoint;
import rigibo.backend.MouseJoint;
import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.PulleyJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * A joint as a scene states it: between two bodies, by places in the world as the scene begins.
 *
 * @param kind of joint; a gear comes with a hinge of each of the two on a third body
 * @param bodies A, B, and what carries geared ones
 * @param x m, where the joint is, or where it holds A; the height of a pulley is {@code toY}
 * @param y m, up
 * @param axis rad, of what slides
 * @param toX m, where a rod holds B, or to where a hand pulls
 * @param toY m, up
 * @param most N with which friction or a hand pulls
 * @param mostTurn N·m with which friction turns
 * @param settings limits, motor, spring, breaking loads
 */
record Link(
        JointKind kind,
        List<BodyDefinition> bodies,
        double x,
        double y,
        double axis,
        double toX,
        double toY,
        double most,
        double mostTurn,
        JointSettings settings) {

    /** Joins what stands for the bodies in a pool. */
    void join(Pool pool, Function<BodyDefinition, RigidBody> added) {
        RigidBody a = added.apply(bodies.get(0));
        RigidBody b = added.apply(bodies.get(1));
        if (kind == JointKind.GEAR) {
            RigidBody carrier = added.apply(bodies.get(2));
            Joint first = pool.join(RevoluteJoint.at(carrier, a, a.x(), a.y()));
            Joint second = pool.join(RevoluteJoint.at(carrier, b, b.x(), b.y()));
            pool.join(GearJoint.of(first, second, 2).with(settings));
        } else if (kind == JointKind.FILTER) {
            pool.join(new FilterJoint(a, b));
        } else {
            pool.join(plain(a, b).with(settings));
        }
    }

    private JointDefinition plain(RigidBody a, RigidBody b) {
        return switch (kind) {
            case REVOLUTE -> RevoluteJoint.at(a, b, x, y);
            case WELD -> WeldJoint.at(a, b, x, y);
            case PRISMATIC -> PrismaticJoint.along(a, b, x, y, axis);
            case WHEEL -> WheelJoint.at(a, b, x, y, axis);
            case DISTANCE -> DistanceJoint.rod(a, x, y, b, toX, toY);
            case MOTOR -> MotorJoint.friction(a, b, most, mostTurn);
            case MOUSE -> hand(MouseJoint.of(a, b, x, y).target(toX, toY));
            case PULLEY -> over(a, b);
            case GEAR, FILTER -> throw new IllegalStateException("joined above: " + kind);
        };
    }

    private MouseJoint hand(MouseJoint usual) {
        return new MouseJoint(
                usual.a(), usual.b(), usual.frameB(), toX, toY, most, usual.settings());
    }

    /** Over two points beside the two bodies, on the same side of both. */
    private PulleyJoint over(RigidBody a, RigidBody b) {
        PulleyJoint usual = PulleyJoint.over(a, b, a.y() + 1);
        double dx = toX - x;
        double dy = toY - y;
        return new PulleyJoint(
                a,
                b,
                usual.frameA(),
                usual.frameB(),
                a.x() + dx,
                a.y() + dy,
                b.x() + dx,
                b.y() + dy,
                1,
                2 * StrictMath.sqrt(dx * dx + dy * dy),
                usual.settings());
    }

    /** The same joint of a scene that is looked at in another way. */
    Link seenBy(Symmetry symmetry, Function<BodyDefinition, BodyDefinition> seen) {
        State from = symmetry.of(new State(x, y, 0, 0, 0, 0), 0);
        State to = symmetry.of(new State(toX, toY, 0, 0, 0, 0), 0);
        double metre = symmetry.metre();
        double force = metre * metre * metre;
        double turned =
                switch (symmetry) {
                    case MIRROR -> Math.PI - axis;
                    case QUARTER_TURN -> axis + Math.PI / 2;
                    case LARGE, SMALL, FAR_AWAY, MOVING -> axis;
                };
        return new Link(
                kind,
                bodies.stream().map(seen).collect(Collectors.toList()),
                from.x(),
                from.y(),
                turned,
                to.x(),
                to.y(),
                force * most,
                force * metre * mostTurn,
                seenBy(symmetry, metre, force));
    }

    private JointSettings seenBy(Symmetry symmetry, double metre, double force) {
        boolean turns = kind == JointKind.REVOLUTE;
        boolean isReversed = turns && symmetry == Symmetry.MIRROR;
        double unit = (isReversed ? -1 : 1) * (turns ? 1 : metre);
        double load = turns || kind == JointKind.WHEEL ? force * metre : force;
        JointLimits limits = settings.limits();
        double lower = unit * (isReversed ? limits.upper() : limits.lower());
        double upper = unit * (isReversed ? limits.lower() : limits.upper());
        JointMotor motor = settings.motor();
        double speed = kind == JointKind.WHEEL ? motor.speed() : unit * motor.speed();
        boolean spins = kind == JointKind.WHEEL && symmetry == Symmetry.MIRROR;
        return settings.limits(new JointLimits(lower, upper, limits.elasticity()))
                .motor(new JointMotor(spins ? -speed : speed, load * motor.most()))
                .breaking(force * settings.breakForce(), force * metre * settings.breakTorque());
    }

    /** Enough to join it again by hand. */
    String words(List<BodyDefinition> all) {
        String numbers =
                bodies.stream()
                        .map(body -> Integer.toString(all.indexOf(body)))
                        .collect(Collectors.joining(", "));
        return String.format(
                "%s of bodies %s at (%s, %s), axis %s, to (%s, %s), most %s and %s, %s",
                kind, numbers, x, y, axis, toX, toY, most, mostTurn, settings);
    }
}

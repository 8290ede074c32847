package rigibo.peers.rust;

import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.MassProperties;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.lab.engine.Link;
import rigibo.lab.engine.World;
import rigibo.peers.Box2dFamily;
import rigibo.peers.Called;
import rigibo.peers.UserForces;

/** A world of the library; it must be closed. */
final class RustWorld implements World {

    /** The default of both engines. */
    static final int USUAL_SUBSTEPS = 4;

    private static final int ONE_WORKER = 1;

    /** Rapier has a bit for each group. */
    private static final int GROUPS_OF_RAPIER = 31;

    private final int engine;
    private final long world;
    private final Called called;
    private final UserForces forces;
    private int bodies;
    private boolean isWatched;

    RustWorld(int engine, Effects effects, int substeps) {
        this.engine = engine;
        called = new Called(effects);
        forces = new UserForces(effects, this);
        world =
                Calls.create(
                        engine,
                        called.gravityX(),
                        called.gravityY(),
                        called.hasSleep(),
                        called.hasContinuousImpacts(),
                        substeps,
                        ONE_WORKER);
    }

    @Override
    public int add(BodyDefinition stated) {
        int group = group(stated);
        if (called.hasContacts()) {
            Outlines.tell(world, engine, stated.shape());
        }
        boolean isDynamic = stated.type() == BodyType.DYNAMIC;
        MassProperties mass = isDynamic ? stated.massProperties() : null;
        Calls.add(
                world,
                kind(stated.type()),
                stated.x(),
                stated.y(),
                stated.angle(),
                stated.velocityX(),
                stated.velocityY(),
                stated.spin(),
                isDynamic ? mass.mass() : 0,
                isDynamic ? mass.inertia() : 0,
                called.friction(stated),
                called.elasticity(stated),
                called.damping(stated),
                stated.gravityScale(),
                group,
                called.hasRotation(),
                stated.awake());
        forces.add(bodies, stated);
        return bodies++;
    }

    private int group(BodyDefinition stated) {
        int group = -Box2dFamily.group(stated);
        if (engine == RapierEngine.NUMBER && group > GROUPS_OF_RAPIER) {
            throw new UnsupportedOperationException("groups other than 0 to " + GROUPS_OF_RAPIER);
        }
        return group;
    }

    private static int kind(BodyType type) {
        return switch (type) {
            case STATIC -> 0;
            case KINEMATIC -> 1;
            case DYNAMIC -> 2;
        };
    }

    @Override
    public void join(Link link) {
        JointSettings settings = link.settings();
        requireKnown(link);
        Calls.join(
                world,
                kind(link),
                link.a(),
                link.b(),
                link.x(),
                link.y(),
                link.toX(),
                link.toY(),
                settings.limits().areAny(),
                settings.limits().lower(),
                settings.limits().upper(),
                settings.motor().drives(),
                settings.motor().speed(),
                settings.motor().most(),
                settings.spring().isThere(),
                settings.spring().hertz(),
                settings.spring().dampingRatio());
    }

    private static int kind(Link link) {
        return switch (link.kind()) {
            case REVOLUTE -> 0;
            case DISTANCE -> 1;
            case WHEEL -> 2;
            case PRISMATIC -> 3;
            case WELD -> 4;
            case MOTOR, MOUSE, GEAR, PULLEY, FILTER -> throw link.unknown();
        };
    }

    private void requireKnown(Link link) {
        Box2dFamily.requireKnown(link);
        boolean isRod = link.kind() == JointKind.DISTANCE && !link.isSpring();
        if (engine == RapierEngine.NUMBER && isRod) {
            throw new UnsupportedOperationException("rods");
        }
    }

    @Override
    public void remove(int body) {
        Calls.remove(world, body);
    }

    @Override
    public void step(double seconds) {
        forces.push(seconds);
        Calls.step(world, seconds);
    }

    @Override
    public void push(int body, double forceX, double forceY) {
        Calls.push(world, body, forceX, forceY);
    }

    @Override
    public void drive(int body, double velocityX, double velocityY, double spin) {
        Calls.drive(world, body, velocityX, velocityY, spin);
    }

    @Override
    public double x(int body) {
        return Calls.x(world, body);
    }

    @Override
    public double y(int body) {
        return Calls.y(world, body);
    }

    @Override
    public double angle(int body) {
        return Calls.angle(world, body);
    }

    @Override
    public double velocityX(int body) {
        return Calls.velocityX(world, body);
    }

    @Override
    public double velocityY(int body) {
        return Calls.velocityY(world, body);
    }

    @Override
    public double spin(int body) {
        return Calls.spin(world, body);
    }

    /** Allows reading; the library keeps impulses in any case. */
    @Override
    public void watchImpulses() {
        isWatched = true;
    }

    @Override
    public double normalImpulse(int a, int b) {
        if (!isWatched) {
            throw new IllegalStateException("nobody watched the impulses");
        }
        return Math.max(a, b) < bodies ? Calls.normalImpulse(world, a, b) : 0;
    }

    @Override
    public double rayCast(double fromX, double fromY, double toX, double toY) {
        return Calls.ray(world, fromX, fromY, toX, toY);
    }

    @Override
    public void close() {
        Calls.destroy(world);
    }
}

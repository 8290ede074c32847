package rigibo.peers.jbox2d;

import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.FieldPoint;
import rigibo.backend.geometry.MassProperties;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.engine.Link;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;
import rigibo.peers.Box2dFamily;
import rigibo.peers.Called;
import rigibo.peers.ImpulseLog;
import rigibo.peers.PeerSettings;
import rigibo.peers.UserForces;

import java.util.ArrayList;
import java.util.List;

/** A world of JBox2D. */
final class Jbox2dWorld implements World {

    private final org.jbox2d.dynamics.World world;
    private final Called called;
    private final UserForces forces;
    private final ImpulseLog log = new ImpulseLog();
    private final int velocityIterations;
    private final int positionIterations;
    private final List<Body> bodies = new ArrayList<>();
    private final Vec2 force = new Vec2();

    Jbox2dWorld(Effects effects, Setting setting) {
        called = new Called(effects);
        forces = new UserForces(effects, this, this::writeState);
        velocityIterations = PeerSettings.iterations(setting, Box2dFamily.VELOCITY_ITERATIONS);
        positionIterations = PeerSettings.iterations(setting, Box2dFamily.POSITION_ITERATIONS);
        world = new org.jbox2d.dynamics.World(vector(called.gravityX(), called.gravityY()));
        world.setAllowSleep(called.hasSleep());
        world.setContinuousPhysics(called.hasContinuousImpacts());
    }

    @Override
    public int add(BodyDefinition stated) {
        int number = bodies.size();
        Body body = world.createBody(definition(stated));
        body.setUserData(number);
        if (called.hasContacts()) {
            FixtureDef fixture = fixture(stated);
            for (Shape shape : Outlines.of(stated.shape())) {
                fixture.shape = shape;
                body.createFixture(fixture);
            }
        }
        if (body.getType() == BodyType.DYNAMIC) {
            body.setMassData(mass(stated.massProperties()));
        }
        bodies.add(body);
        forces.add(number, stated);
        return number;
    }

    private BodyDef definition(BodyDefinition stated) {
        BodyDef definition = new BodyDef();
        definition.type =
                switch (stated.type()) {
                    case DYNAMIC -> BodyType.DYNAMIC;
                    case STATIC -> BodyType.STATIC;
                    case KINEMATIC -> BodyType.KINEMATIC;
                };
        definition.position = vector(stated.x(), stated.y());
        definition.angle = (float) stated.angle();
        definition.linearVelocity = vector(stated.velocityX(), stated.velocityY());
        definition.angularVelocity = (float) stated.spin();
        definition.linearDamping = (float) called.damping(stated);
        definition.gravityScale = (float) stated.gravityScale();
        definition.fixedRotation = !called.hasRotation();
        definition.allowSleep = called.hasSleep();
        definition.awake = stated.awake();
        return definition;
    }

    /** A fixture without a density, since the mass is stated. */
    private FixtureDef fixture(BodyDefinition stated) {
        FixtureDef fixture = new FixtureDef();
        fixture.friction = (float) called.friction(stated);
        fixture.restitution = (float) called.elasticity(stated);
        fixture.filter.groupIndex = Box2dFamily.group(stated);
        return fixture;
    }

    private static MassData mass(MassProperties stated) {
        MassData mass = new MassData();
        mass.mass = (float) stated.mass();
        mass.I = (float) stated.inertia();
        return mass;
    }

    private static Vec2 vector(double x, double y) {
        return new Vec2((float) x, (float) y);
    }

    @Override
    public void join(Link link) {
        world.createJoint(Connections.of(link, bodies.get(link.a()), bodies.get(link.b())));
    }

    @Override
    public void remove(int body) {
        world.destroyBody(bodies.get(body));
    }

    @Override
    public void step(double seconds) {
        forces.push(seconds);
        log.clear();
        world.step((float) seconds, velocityIterations, positionIterations);
    }

    @Override
    public void push(int body, double forceX, double forceY) {
        force.set((float) forceX, (float) forceY);
        bodies.get(body).applyForceToCenter(force);
    }

    private void writeState(int number, FieldPoint point) {
        Body body = bodies.get(number);
        Vec2 centre = body.getWorldCenter();
        Vec2 velocity = body.getLinearVelocity();
        point.x = centre.x;
        point.y = centre.y;
        point.velocityX = velocity.x;
        point.velocityY = velocity.y;
    }

    @Override
    public void drive(int body, double velocityX, double velocityY, double spin) {
        Body driven = bodies.get(body);
        driven.setLinearVelocity(vector(velocityX, velocityY));
        driven.setAngularVelocity((float) spin);
    }

    @Override
    public double x(int body) {
        return bodies.get(body).getWorldCenter().x;
    }

    @Override
    public double y(int body) {
        return bodies.get(body).getWorldCenter().y;
    }

    @Override
    public double angle(int body) {
        return bodies.get(body).getAngle();
    }

    @Override
    public double velocityX(int body) {
        return bodies.get(body).getLinearVelocity().x;
    }

    @Override
    public double velocityY(int body) {
        return bodies.get(body).getLinearVelocity().y;
    }

    @Override
    public double spin(int body) {
        return bodies.get(body).getAngularVelocity();
    }

    @Override
    public void watchImpulses() {
        log.open();
        world.setContactListener(new ImpulseListener(log));
    }

    @Override
    public double normalImpulse(int a, int b) {
        return log.between(a, b);
    }
}

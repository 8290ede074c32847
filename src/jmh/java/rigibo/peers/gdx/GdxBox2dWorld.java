package rigibo.peers.gdx;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.BodyDef.BodyType;
import com.badlogic.gdx.physics.box2d.FixtureDef;
import com.badlogic.gdx.physics.box2d.MassData;
import com.badlogic.gdx.physics.box2d.RayCastCallback;
import com.badlogic.gdx.physics.box2d.Shape;

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

/** A world of Box2D; it must be closed. */
final class GdxBox2dWorld implements World {

    private final com.badlogic.gdx.physics.box2d.World world;
    private final Called called;
    private final UserForces forces;
    private final ImpulseLog log = new ImpulseLog();
    private final int velocityIterations;
    private final int positionIterations;
    private final List<Body> bodies = new ArrayList<>();

    /** The ends of a ray, and the share of its length to the nearest hit so far. */
    private final Vector2 from = new Vector2();

    private final Vector2 to = new Vector2();
    private float nearest;
    private final RayCastCallback nearestHit =
            (fixture, point, normal, fraction) -> nearest = fraction;

    GdxBox2dWorld(Effects effects, Setting setting) {
        called = new Called(effects);
        forces = new UserForces(effects, this, this::writeState);
        velocityIterations = PeerSettings.iterations(setting, Box2dFamily.VELOCITY_ITERATIONS);
        positionIterations = PeerSettings.iterations(setting, Box2dFamily.POSITION_ITERATIONS);
        Vector2 gravity = new Vector2((float) called.gravityX(), (float) called.gravityY());
        world = new com.badlogic.gdx.physics.box2d.World(gravity, called.hasSleep());
        world.setContinuousPhysics(called.hasContinuousImpacts());
    }

    @Override
    public int add(BodyDefinition stated) {
        int number = bodies.size();
        Body body = world.createBody(definition(stated));
        body.setUserData(number);
        if (called.hasContacts()) {
            outline(body, stated);
        }
        if (body.getType() == BodyType.DynamicBody) {
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
                    case DYNAMIC -> BodyType.DynamicBody;
                    case STATIC -> BodyType.StaticBody;
                    case KINEMATIC -> BodyType.KinematicBody;
                };
        definition.position.set((float) stated.x(), (float) stated.y());
        definition.angle = (float) stated.angle();
        definition.linearVelocity.set((float) stated.velocityX(), (float) stated.velocityY());
        definition.angularVelocity = (float) stated.spin();
        definition.linearDamping = (float) called.damping(stated);
        definition.gravityScale = (float) stated.gravityScale();
        definition.fixedRotation = !called.hasRotation();
        definition.allowSleep = called.hasSleep();
        definition.awake = stated.awake();
        return definition;
    }

    /** Adds a shape without a density, since the mass is stated. Box2D copies the shape. */
    private void outline(Body body, BodyDefinition stated) {
        FixtureDef fixture = new FixtureDef();
        fixture.friction = (float) called.friction(stated);
        fixture.restitution = (float) called.elasticity(stated);
        fixture.filter.groupIndex = Box2dFamily.group(stated);
        for (Shape shape : Outlines.of(stated.shape())) {
            fixture.shape = shape;
            body.createFixture(fixture);
            shape.dispose();
        }
    }

    private static MassData mass(MassProperties stated) {
        MassData mass = new MassData();
        mass.mass = (float) stated.mass();
        mass.I = (float) stated.inertia();
        return mass;
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
        bodies.get(body).applyForceToCenter((float) forceX, (float) forceY, true);
    }

    private void writeState(int number, FieldPoint point) {
        Body body = bodies.get(number);
        Vector2 centre = body.getWorldCenter();
        Vector2 velocity = body.getLinearVelocity();
        point.x = centre.x;
        point.y = centre.y;
        point.velocityX = velocity.x;
        point.velocityY = velocity.y;
    }

    @Override
    public void drive(int body, double velocityX, double velocityY, double spin) {
        Body driven = bodies.get(body);
        driven.setLinearVelocity((float) velocityX, (float) velocityY);
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

    @Override
    public double rayCast(double fromX, double fromY, double toX, double toY) {
        from.set((float) fromX, (float) fromY);
        to.set((float) toX, (float) toY);
        nearest = 1;
        world.rayCast(nearestHit, from, to);
        return nearest;
    }

    @Override
    public void close() {
        world.dispose();
    }
}

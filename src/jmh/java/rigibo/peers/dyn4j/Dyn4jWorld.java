package rigibo.peers.dyn4j;

import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.dynamics.Settings;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;

import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.MassProperties;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.engine.Link;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;
import rigibo.peers.Called;
import rigibo.peers.ImpulseLog;
import rigibo.peers.PeerSettings;
import rigibo.peers.UserForces;

import java.util.ArrayList;
import java.util.List;

/**
 * A world of dyn4j. Its default mixes materials as we do. Its angles are within ±π, so turns are
 * not counted.
 */
final class Dyn4jWorld implements World {

    private final org.dyn4j.world.World<Body> world = new org.dyn4j.world.World<>();
    private final Called called;
    private final UserForces forces;
    private final ImpulseLog log = new ImpulseLog();
    private final List<Body> bodies = new ArrayList<>();

    Dyn4jWorld(Effects effects, Setting setting) {
        called = new Called(effects);
        forces = new UserForces(effects, this);
        world.setGravity(called.gravityX(), called.gravityY());
        set(world.getSettings(), setting);
    }

    private void set(Settings settings, Setting setting) {
        settings.setVelocityConstraintSolverIterations(
                PeerSettings.iterations(setting, settings.getVelocityConstraintSolverIterations()));
        settings.setPositionConstraintSolverIterations(
                PeerSettings.iterations(setting, settings.getPositionConstraintSolverIterations()));
        settings.setAtRestDetectionEnabled(called.hasSleep());
        settings.setContinuousDetectionMode(
                called.hasContinuousImpacts()
                        ? ContinuousDetectionMode.ALL
                        : ContinuousDetectionMode.NONE);
    }

    @Override
    public int add(BodyDefinition stated) {
        int number = bodies.size();
        Body body = new Body();
        body.setUserData(number);
        if (called.hasContacts()) {
            for (Convex piece : Outlines.of(stated.shape())) {
                body.addFixture(fixture(piece, stated));
            }
        }
        body.getTransform().setRotation(stated.angle());
        body.translate(stated.x(), stated.y());
        setMass(body, stated);
        move(body, stated);
        world.addBody(body);
        bodies.add(body);
        forces.add(number, stated);
        return number;
    }

    private BodyFixture fixture(Convex piece, BodyDefinition stated) {
        BodyFixture fixture = new BodyFixture(piece);
        fixture.setFriction(called.friction(stated));
        fixture.setRestitution(called.elasticity(stated));
        fixture.setFilter(new GroupFilter(stated.group()));
        return fixture;
    }

    /** Sets the mass; a body with infinite mass and a velocity is kinematic. */
    private void setMass(Body body, BodyDefinition stated) {
        if (stated.type() != BodyType.DYNAMIC) {
            body.setMass(MassType.INFINITE);
            return;
        }
        MassProperties mass = stated.massProperties();
        body.setMass(new Mass(new Vector2(), mass.mass(), mass.inertia()));
        body.setMassType(called.hasRotation() ? MassType.NORMAL : MassType.FIXED_ANGULAR_VELOCITY);
    }

    private void move(Body body, BodyDefinition stated) {
        body.setLinearVelocity(stated.velocityX(), stated.velocityY());
        body.setAngularVelocity(stated.spin());
        body.setGravityScale(stated.gravityScale());
        body.setLinearDamping(called.damping(stated));
        // By default all rotation is damped a little, which no scene declares.
        body.setAngularDamping(0);
        body.setAtRestDetectionEnabled(called.hasSleep());
        body.setAtRest(!stated.awake());
    }

    @Override
    public void join(Link link) {
        world.addJoint(Connections.of(link, bodies.get(link.a()), bodies.get(link.b())));
    }

    @Override
    public void remove(int body) {
        world.removeBody(bodies.get(body));
    }

    @Override
    public void step(double seconds) {
        forces.push(seconds);
        log.clear();
        world.step(1, seconds);
    }

    @Override
    public void push(int body, double forceX, double forceY) {
        // dyn4j keeps the vector until the step, so each force needs its own.
        bodies.get(body).applyForce(new Vector2(forceX, forceY));
    }

    @Override
    public void drive(int body, double velocityX, double velocityY, double spin) {
        Body driven = bodies.get(body);
        driven.setLinearVelocity(velocityX, velocityY);
        driven.setAngularVelocity(spin);
    }

    @Override
    public double x(int body) {
        return bodies.get(body).getTransform().getTranslationX();
    }

    @Override
    public double y(int body) {
        return bodies.get(body).getTransform().getTranslationY();
    }

    @Override
    public double angle(int body) {
        return bodies.get(body).getTransform().getRotationAngle();
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
        // A second listener would count each impulse twice.
        world.removeAllContactListeners();
        world.addContactListener(new ImpulseListener(log));
    }

    @Override
    public double normalImpulse(int a, int b) {
        return log.between(a, b);
    }
}

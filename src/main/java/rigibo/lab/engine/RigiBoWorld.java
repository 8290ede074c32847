package rigibo.lab.engine;

import rigibo.backend.ContactEvent;
import rigibo.backend.Pool;
import rigibo.backend.RayHit;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.child.Work;

import java.util.ArrayList;
import java.util.List;

/** One of our pools. */
final class RigiBoWorld implements World {

    private final Pool pool;
    private final List<RigidBody> bodies = new ArrayList<>();

    RigiBoWorld(Pool pool) {
        this.pool = pool;
        bodies.addAll(pool.bodies());
    }

    @Override
    public int add(BodyDefinition body) {
        bodies.add(pool.add(body));
        return bodies.size() - 1;
    }

    @Override
    public void join(Link link) {
        pool.join(link.between(bodies.get(link.a()), bodies.get(link.b())));
    }

    @Override
    public void remove(int body) {
        pool.remove(bodies.get(body));
    }

    @Override
    public void step(double seconds) {
        pool.step(seconds);
    }

    @Override
    public void push(int body, double forceX, double forceY) {
        RigidBody pushed = bodies.get(body);
        pushed.applyForce(forceX, forceY, pushed.x(), pushed.y());
    }

    @Override
    public void drive(int body, double velocityX, double velocityY, double spin) {
        RigidBody driven = bodies.get(body);
        driven.velocity(velocityX, velocityY);
        driven.spin(spin);
    }

    @Override
    public double x(int body) {
        return bodies.get(body).x();
    }

    @Override
    public double y(int body) {
        return bodies.get(body).y();
    }

    @Override
    public double angle(int body) {
        return bodies.get(body).angle();
    }

    @Override
    public double velocityX(int body) {
        return bodies.get(body).velocityX();
    }

    @Override
    public double velocityY(int body) {
        return bodies.get(body).velocityY();
    }

    @Override
    public double spin(int body) {
        return bodies.get(body).angularVelocity();
    }

    @Override
    public double normalImpulse(int a, int b) {
        double sum = 0;
        for (ContactEvent event : pool.contactEvents()) {
            boolean isThis = event.a() == bodies.get(a) && event.b() == bodies.get(b);
            boolean isReverse = event.a() == bodies.get(b) && event.b() == bodies.get(a);
            sum += isThis || isReverse ? event.impulse() : 0;
        }
        return sum;
    }

    @Override
    public double rayCast(double fromX, double fromY, double toX, double toY) {
        return pool.rayCast(fromX, fromY, toX, toY).map(RayHit::fraction).orElse(1.0);
    }

    @Override
    public Work lastStep() {
        return Work.of(pool.report());
    }
}

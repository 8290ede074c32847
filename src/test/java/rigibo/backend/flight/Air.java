package rigibo.backend.flight;

import rigibo.backend.FilledStorage;
import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

/** Bodies in the air, with their pairs and manifolds as flight finds them within a step. */
final class Air {

    static final Effect[] ALL = {new Contacts(), new Rotation(), new Friction(), new Restitution()};

    final FilledStorage storage;
    final Bodies bodies;
    final Pairs pairs;
    final Broadphase broadphase;
    final Narrowphase narrowphase;
    final Accuracy accuracy;

    private final Flight flight;

    Air(Accuracy accuracy) {
        this(accuracy, ALL);
    }

    Air(Accuracy accuracy, Effect... effects) {
        this.accuracy = accuracy;
        storage = new FilledStorage(accuracy, effects);
        bodies = storage.bodies;
        pairs = storage.pairs;
        broadphase = storage.broadphase();
        narrowphase = new Narrowphase(storage.data);
        flight = new Flight(storage.data, narrowphase, broadphase, accuracy, null);
    }

    /** A dynamic body of 1 kg without friction. */
    static BodyDefinition body(Shape shape, double elasticity) {
        return BodyDefinition.dynamic(shape).mass(1).material(new Material(1, 0, elasticity));
    }

    static BodyDefinition disc(double x, double velocityX, double elasticity) {
        return body(new Circle(1), elasticity).at(x, 0).velocity(velocityX, 0);
    }

    /**
     * A fixed wall, 1 m thick, with a face at x; it lies to the left of the face if {@code side} is
     * 1.
     */
    static BodyDefinition wall(double face, int side) {
        return BodyDefinition.fixed(Polygon.box(1, 20))
                .at(face + side * 0.5, 0)
                .material(new Material(1, 0, 0));
    }

    int add(BodyDefinition definition) {
        return storage.add(definition);
    }

    /** Sets the acceleration of all dynamic bodies, m/s². */
    void pull(double x, double y) {
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isDynamic(slot)) {
                bodies.accelerationX[slot] = x;
                bodies.accelerationY[slot] = y;
            }
        }
    }

    /** Runs the stages of a step that come before flight. */
    void meet(double dt) {
        storage.data.roster.refresh(bodies);
        broadphase.update(dt);
        narrowphase.collide(dt);
    }

    /** Makes one step; all bodies fly except those that were put in a pile. */
    void fly(double dt) {
        meet(dt);
        flight.fly(dt);
    }

    /** Makes a body part of a pile. */
    void pile(int slot) {
        bodies.piled[slot] = true;
    }

    int pairOf(int a, int b) {
        return pairs.index.find(a, b);
    }
}

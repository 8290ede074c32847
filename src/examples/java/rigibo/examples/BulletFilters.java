package rigibo.examples;

import rigibo.backend.ContactEvent;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Shots that pass through friends and hit enemies: categories and masks say who meets whom. */
public final class BulletFilters implements Exhibit {

    private static final int FRIEND = 1 << 1;
    private static final int ENEMY = 1 << 2;
    private static final Filter SHOT = Filter.ALL.category(FRIEND).mask(~FRIEND);
    private static final double EVERY = 0.5; // s

    RigidBody friend;
    RigidBody enemy;
    int hits;
    private double next = EVERY;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 4)).at(4.75, 2));
        Shape person = new Capsule(0.5, 0.3);
        BodyDefinition upright =
                BodyDefinition.dynamic(person)
                        .angle(Math.PI / 2)
                        .material(new Material(100, 0.5, 0))
                        .lockRotation();
        pool.add(upright.at(-3.6, 0.8).filter(Filter.ALL.category(FRIEND)));
        friend = pool.add(upright.at(-1, 0.8).filter(Filter.ALL.category(FRIEND)));
        enemy = pool.add(upright.at(2, 0.8).filter(Filter.ALL.category(ENEMY)));
    }

    @Override
    public void beforeStep(Pool pool) {
        for (ContactEvent contact : pool.contactEvents()) {
            RigidBody other = contact.a() == enemy ? contact.b() : contact.a();
            boolean isHit =
                    other.filter().equals(SHOT) && (contact.a() == enemy || contact.b() == enemy);
            hits += isHit && contact.phase() == ContactEvent.Phase.BEGIN ? 1 : 0;
        }
        if (pool.time() >= next) {
            next += EVERY;
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.06))
                            .at(-3.2, 1.1)
                            .velocity(60, 1)
                            .material(new Material(20, 0.3, 0.2))
                            .filter(SHOT));
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count("× " + hits);
    }

    @Override
    public View view() {
        return new View(0, 2, 10);
    }

    /** Prints who was hit after three seconds. */
    public static void main(String[] arguments) {
        BulletFilters example = new BulletFilters();
        example.run(example.open(), 3);
        System.out.printf(
                "enemy hit %d times, friend at %.3f m%n", example.hits, example.friend.x());
    }
}

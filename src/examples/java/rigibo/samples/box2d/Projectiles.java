package rigibo.samples.box2d;

import rigibo.backend.ContactEvent;
import rigibo.backend.Explosion;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Length;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** Shots burst where they hit; the right button shoots. */
public final class Projectiles implements Exhibit {
    private final List<RigidBody> shots = new ArrayList<>();
    private int count;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        for (int i = 0; i < 40; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.5, 0.5).rounded(0.03))
                            .at(1 + 0.58 * (i % 5), 0.28 + 0.56 * (i / 5)));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        for (ContactEvent contact : pool.contactEvents()) {
            RigidBody shot = shots.contains(contact.a()) ? contact.a() : contact.b();
            if (shots.remove(shot)) {
                pool.remove(shot);
                pool.explode(
                        Explosion.at(contact.x(), contact.y())
                                .radius(0.5)
                                .falloff(1)
                                .impulsePerMetre(3));
            }
        }
        if (pool.time() >= 1 + 1.5 * count) {
            count++;
            act(pool, 2, 1 + count % 4);
        }
    }

    /** Flies from the left edge towards a point. */
    @Override
    public void act(Pool pool, double x, double y) {
        double dx = x + 4;
        double dy = y - 2;
        double way = Length.hypot(dx, dy);
        shots.add(
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.15))
                                .at(-4, 2)
                                .velocity(30 * dx / way, 30 * dy / way)));
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}

package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Every four seconds whatever touches the floor is woken. */
public final class WakeTouching implements Exhibit {
    private RigidBody floor;
    private int count;

    @Override
    public void build(Pool pool) {

        floor = pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        for (int i = 0; i < 9; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.8, 0.8))
                            .at(-3.2 + 0.8 * i + 0.05 * i, 0.4 + 0.6 * (i % 2)));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        if (pool.time() >= 4 * (count + 1)) {
            count++;
            pool.bodies().stream()
                    .filter(body -> pool.touching(body, floor))
                    .forEach(RigidBody::wake);
        }
    }

    @Override
    public View view() {
        return new View(0, 2, 9);
    }
}

package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** A pyramid is taken away and built anew every second. */
public final class CreateDestroy implements Exhibit {
    private final List<RigidBody> pyramid = new ArrayList<>();
    private int count;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        pile(pool);
    }

    @Override
    public void beforeStep(Pool pool) {
        if (pool.time() >= count + 1) {
            count++;
            pyramid.forEach(pool::remove);
            pyramid.clear();
            pile(pool);
        }
    }

    private void pile(Pool pool) {
        for (int row = 0; row < 12; row++) {
            for (int i = 0; i < 12 - row; i++) {
                double x = 0.55 * (i - (11 - row) / 2.0);
                pyramid.add(
                        pool.add(
                                BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                        .at(x, 0.25 + 0.5 * row)));
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 9);
    }
}

package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Outlines with dents are cut into convex pieces. */
public final class DecompositionShapes implements Exhibit {
    private static final double[][] OUTLINES = {
        {
            0, 1, -0.3, 0.3, -1, 0.2, -0.4, -0.2, -0.6, -0.9, 0, -0.5, 0.6, -0.9, 0.4, -0.2, 1, 0.2,
            0.3, 0.3
        },
        {0, 0, 1.2, 0, 1.2, 0.3, 0.3, 0.3, 0.3, 0.6, 0.9, 0.6, 0.9, 0.9, 0, 0.9},
        {0, 0, 0.5, 0.4, 1, 0, 0.8, 0.9, 0.2, 0.9}
    };

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        for (int i = 0; i < 12; i++) {
            pool.add(
                    BodyDefinition.dynamic(Compound.ofOutline(OUTLINES[i % 3]))
                            .at(-3 + 2 * (i % 4), 1.2 + 2 * (i / 4))
                            .angle(i));
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(
                String.valueOf(
                        pool.bodies().stream().mapToInt(body -> body.shape().parts()).sum() - 1));
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}

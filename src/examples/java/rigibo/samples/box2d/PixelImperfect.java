package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A box that may not turn falls beside a block and stays aside. */
public final class PixelImperfect implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 2)).at(0, 1));
        pool.add(
                BodyDefinition.dynamic(Polygon.box(1, 1).rounded(0.05))
                        .at(1.0501 + 0.5 - 0.5 + 0.0001, 5)
                        .lockRotation()
                        .material(new Material(1, 0, 0)));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.8, 0.8)).at(-2, 5).lockRotation());
    }

    @Override
    public View view() {
        return new View(0, 2.6, 9);
    }
}

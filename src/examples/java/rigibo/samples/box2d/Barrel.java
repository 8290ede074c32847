package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Arrows of two triangles each rain into a barrel. */
public final class Barrel implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(-4.25, 4));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(4.25, 4));
        Compound arrow = Compound.ofOutline(-0.3, 0, 0, 0.15, 0.3, 0, 0, 0.5);
        for (int i = 0; i < 120; i++) {
            pool.add(
                    BodyDefinition.dynamic(arrow)
                            .at(-3.3 + 0.73 * (i % 10), 1 + 0.7 * (i / 10))
                            .angle(0.5 * i));
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}

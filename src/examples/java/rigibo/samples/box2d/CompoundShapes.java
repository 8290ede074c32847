package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Tables and crosses of several boxes fall as one body each. */
public final class CompoundShapes implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(24, 1)).at(0, -0.5));
        Compound table =
                Compound.of(
                        Part.of(Polygon.box(1.6, 0.2)).at(0, 1),
                        Part.of(Polygon.box(0.2, 1)).at(-0.6, 0.4),
                        Part.of(Polygon.box(0.2, 1)).at(0.6, 0.4));
        Compound cross =
                Compound.of(Part.of(Polygon.box(1.2, 0.3)), Part.of(Polygon.box(0.3, 1.2)));
        for (int i = 0; i < 10; i++) {
            pool.add(
                    BodyDefinition.dynamic(i % 2 == 0 ? table : cross)
                            .at(-3 + 1.7 * (i % 4), 1.2 + 1.6 * (i / 4))
                            .angle(0.2 * i));
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 11);
    }
}

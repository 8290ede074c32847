package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A square drum turns, boxes tumble in it. */
public final class Tumbler implements Exhibit {
    @Override
    public void build(Pool pool) {

        pool.add(BodyDefinition.kinematic(drum(6)).at(0, 4).spin(0.5));
        for (int i = 0; i < 196; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.25, 0.25))
                            .at(-2.2 + 0.34 * (i % 14), 1.8 + 0.34 * (i / 14)));
        }
    }

    /** Four walls around a square space of the given size, m. */
    static Compound drum(double inner) {
        double at = inner / 2 + 0.1;
        return Compound.of(
                Part.of(Polygon.box(inner + 0.4, 0.2)).at(0, at),
                Part.of(Polygon.box(inner + 0.4, 0.2)).at(0, -at),
                Part.of(Polygon.box(0.2, inner)).at(at, 0),
                Part.of(Polygon.box(0.2, inner)).at(-at, 0));
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}

package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Ellipses as polygons of many corners come to lie flat. */
public final class Ellipses implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 6)).at(-3.8, 3));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 6)).at(3.8, 3));
        double[] corners = new double[48];
        for (int i = 0; i < 24; i++) {
            corners[2 * i] = 0.5 * Angle.cos(Math.PI * i / 12);
            corners[2 * i + 1] = 0.25 * Angle.sin(Math.PI * i / 12);
        }
        for (int i = 0; i < 40; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.of(corners))
                            .at(-2.8 + 0.8 * (i % 8), 0.6 + 1.1 * (i / 8))
                            .angle(0.4 * i)
                            .material(new Material(1, 0.6, 0)));
        }
    }

    @Override
    public View view() {
        return new View(0, 3.2, 10);
    }
}

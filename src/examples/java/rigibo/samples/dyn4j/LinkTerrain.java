package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Bodies of all shapes come down a hilly line of edges. */
public final class LinkTerrain implements Exhibit {
    @Override
    public void build(Pool pool) {

        double[] xy = new double[82];
        for (int i = 0; i <= 40; i++) {
            double x = 6 - 0.3 * i;
            xy[2 * i] = x;
            xy[2 * i + 1] = 1.2 - 0.35 * x + 0.35 * Angle.sin(1.9 * x);
        }
        pool.add(BodyDefinition.fixed(Chain.open(xy)));
        Shape[] shapes = {
            new Circle(0.3), new Capsule(0.3, 0.18), Polygon.box(0.5, 0.5), Polygon.regular(5, 0.3)
        };
        for (int i = 0; i < 16; i++) {
            pool.add(
                    BodyDefinition.dynamic(shapes[i % 4])
                            .at(-4 + 0.45 * i, 5.5)
                            .material(new Material(1, 0.3, 0.1)));
        }
    }

    @Override
    public View view() {
        return new View(0, 2.6, 9);
    }
}

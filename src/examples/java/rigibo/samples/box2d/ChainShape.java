package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A loop of edges as a bowl, with something of every shape in it. */
public final class ChainShape implements Exhibit {
    @Override
    public void build(Pool pool) {

        double[] xy = new double[48];
        for (int i = 0; i < 24; i++) {
            double angle = -Math.PI * i / 12;
            double radius = 3.4 + 0.35 * Angle.cos(6 * angle);
            xy[2 * i] = radius * Angle.cos(angle);
            xy[2 * i + 1] = 4 + radius * Angle.sin(angle);
        }
        pool.add(BodyDefinition.fixed(Chain.loop(xy)));
        Shape[] shapes = {
            new Circle(0.25),
            new Capsule(0.3, 0.15),
            Polygon.box(0.5, 0.5),
            Polygon.regular(3, 0.35)
        };
        for (int i = 0; i < 24; i++) {
            pool.add(
                    BodyDefinition.dynamic(shapes[i % 4])
                            .at(-1.5 + 0.6 * (i % 6), 3 + 0.7 * (i / 6))
                            .angle(i));
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 10);
    }
}

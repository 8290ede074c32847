package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.Locale;

/** A disc slides at 30 m/s over an edge chain and meets no bump. */
public final class ChainSlide implements Exhibit {
    private RigidBody disc;

    @Override
    public void build(Pool pool) {

        double[] xy = new double[122];
        for (int i = 0; i <= 60; i++) {
            xy[2 * i] = 15 - 0.5 * i;
            xy[2 * i + 1] = 0;
        }
        pool.add(BodyDefinition.fixed(Chain.open(xy)));
        pool.add(BodyDefinition.fixed(Polygon.box(0.3, 2)).at(4.3, 1));
        disc =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.4))
                                .at(-14, 0.4)
                                .velocity(30, 0)
                                .material(new Material(1, 0, 1)));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(String.format(Locale.ROOT, "%.6f m/s", disc.velocityX()));
    }

    @Override
    public View view() {
        return new View(0, 2, 10);
    }
}

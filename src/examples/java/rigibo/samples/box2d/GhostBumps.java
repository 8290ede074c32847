package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Box, disc and capsule slide over a flat chain without a bump. */
public final class GhostBumps implements Exhibit {
    @Override
    public void build(Pool pool) {

        double[] xy = new double[164];
        for (int i = 0; i <= 80; i++) {
            xy[2 * i] = 10 - 0.25 * i;
            xy[2 * i + 1] = 0;
        }
        xy[162] = -10;
        xy[163] = 4;
        pool.add(BodyDefinition.fixed(Chain.open(xy)));
        Material ice = new Material(1, 0, 0);
        pool.add(
                BodyDefinition.dynamic(Polygon.box(0.8, 0.8))
                        .at(-3.4, 0.4)
                        .velocity(2, 0)
                        .material(ice));
        pool.add(
                BodyDefinition.dynamic(Polygon.box(0.6, 0.6).rounded(0.1))
                        .at(-2, 0.4)
                        .velocity(2, 0)
                        .material(ice));
        pool.add(
                BodyDefinition.dynamic(new Capsule(0.3, 0.3))
                        .at(-0.4, 0.3)
                        .velocity(2, 0)
                        .material(ice));
        pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(1.2, 0.4).velocity(2, 0).material(ice));
    }

    @Override
    public View view() {
        return new View(0, 1.6, 9);
    }
}

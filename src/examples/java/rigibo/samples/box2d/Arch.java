package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Wedges hold each other; the load over them presses them tighter. */
public final class Arch implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(24, 1)).at(0, -0.5));
        int stones = 11;
        double inner = 2.6;
        double outer = 3.5;
        Material stone = new Material(20, 0.7, 0);
        for (int i = 0; i < stones; i++) {
            double from = Math.PI * i / stones;
            double to = Math.PI * (i + 1) / stones;
            Polygon wedge =
                    Polygon.of(
                            inner * Angle.cos(from),
                            inner * Angle.sin(from),
                            outer * Angle.cos(from),
                            outer * Angle.sin(from),
                            outer * Angle.cos(to),
                            outer * Angle.sin(to),
                            inner * Angle.cos(to),
                            inner * Angle.sin(to));
            pool.add(
                    BodyDefinition.dynamic(wedge)
                            .at(wedge.centroidX(), wedge.centroidY())
                            .material(stone));
        }
        for (int i = 0; i < 3; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(1.6, 0.4))
                            .at(0, 3.75 + 0.4 * i)
                            .material(stone));
        }
    }

    @Override
    public View view() {
        return new View(0, 2.6, 9);
    }
}

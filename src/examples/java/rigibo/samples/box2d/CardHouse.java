package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Thin cards stand by friction alone. */
public final class CardHouse implements Exhibit {
    private static final double LEAN = 0.43; // rad
    private static final double LENGTH = 1.2; // m
    private static final double THICK = 0.05; // m

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        double rise = LENGTH * Angle.cos(LEAN) + THICK * Angle.sin(LEAN);
        double half = LENGTH / 2 * Angle.sin(LEAN) + THICK / 2 * Angle.cos(LEAN);
        double pitch = 4 * half + 0.05;
        for (int storey = 0; storey < 4; storey++) {
            double y = storey * (rise + THICK);
            int tents = 4 - storey;
            for (int i = 0; i < tents; i++) {
                double x = (i - (tents - 1) / 2.0) * pitch;
                card(pool, x - half, y + rise / 2, Math.PI / 2 - LEAN);
                card(pool, x + half, y + rise / 2, Math.PI / 2 + LEAN);
                if (i < tents - 1) {
                    card(pool, x + pitch / 2, y + rise + THICK / 2, 0);
                }
            }
        }
    }

    private static void card(Pool pool, double x, double y, double angle) {
        pool.add(
                BodyDefinition.dynamic(Polygon.box(angle == 0 ? 2 * LENGTH : LENGTH, THICK))
                        .at(x, y)
                        .angle(angle)
                        .material(new Material(1, 0.7, 0)));
    }

    @Override
    public View view() {
        return new View(0, 2.2, 8);
    }
}

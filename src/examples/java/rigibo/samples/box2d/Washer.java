package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** A ring of driven pieces with fins stirs the bodies inside. */
public final class Washer implements Exhibit {
    @Override
    public void build(Pool pool) {

        List<Part> parts = new ArrayList<>();
        for (int i = 0; i < 30; i++) {
            double angle = Math.PI * i / 15;
            parts.add(
                    Part.of(Polygon.box(0.3, 0.84))
                            .at(3.8 * Angle.cos(angle), 3.8 * Angle.sin(angle))
                            .angle(angle));
            if (i % 6 == 0) {
                parts.add(
                        Part.of(Polygon.box(0.8, 0.15))
                                .at(3.3 * Angle.cos(angle), 3.3 * Angle.sin(angle))
                                .angle(angle));
            }
        }
        pool.add(BodyDefinition.kinematic(Compound.of(parts)).at(0, 4).spin(0.7));
        for (int i = 0; i < 144; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.25, 0.25))
                            .at(-1.9 + 0.34 * (i % 12), 2.1 + 0.34 * (i / 12)));
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}

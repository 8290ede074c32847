package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** A bar turns in a ring full of discs, capsules and boxes. */
public final class Spinner implements Exhibit {
    @Override
    public void build(Pool pool) {

        List<Part> ring = new ArrayList<>();
        for (int i = 0; i < 48; i++) {
            double angle = Math.PI * i / 24;
            ring.add(
                    Part.of(Polygon.box(0.3, 0.6))
                            .at(4 * Angle.cos(angle), 4 * Angle.sin(angle))
                            .angle(angle));
        }
        pool.add(BodyDefinition.fixed(Compound.of(ring)).at(0, 4));
        pool.add(
                BodyDefinition.kinematic(Polygon.box(5.6, 0.25).rounded(0.1)).at(0, 2.6).spin(1.5));
        Shape[] shapes = {new Circle(0.16), new Capsule(0.15, 0.1), Polygon.box(0.28, 0.28)};
        for (int i = 0; i < 150; i++) {
            pool.add(
                    BodyDefinition.dynamic(shapes[i % 3])
                            .at(-2.2 + 0.45 * (i % 11), 3.4 + 0.4 * (i / 11 % 10)));
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}

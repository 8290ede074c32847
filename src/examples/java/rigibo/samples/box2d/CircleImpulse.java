package rigibo.samples.box2d;

import rigibo.backend.ContactEvent;
import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** How hard each contact presses, drawn as a line. */
public final class CircleImpulse implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(-4.25, 4));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(4.25, 4));
        for (int i = 0; i < 30; i++) {
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.25 + 0.05 * (i % 3)))
                            .at(-2.8 + 0.9 * (i % 7), 1 + 0.9 * (i / 7)));
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (ContactEvent contact : pool.contactEvents()) {
            double length = 0.6 * Math.sqrt(contact.impulse());
            sketch.line(
                    contact.x(),
                    contact.y(),
                    contact.x() + length * contact.normalX(),
                    contact.y() + length * contact.normalY(),
                    Sketch.Tone.BAD);
        }
    }

    @Override
    public View view() {
        return new View(0, 3.4, 10);
    }
}

package rigibo.samples.box2d;

import rigibo.backend.ContactEvent;
import rigibo.backend.Pool;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** A ball in a bowl: its points of contact from step to step. */
public final class PersistentContact implements Exhibit {
    @Override
    public void build(Pool pool) {

        double[] xy = new double[42];
        for (int i = 0; i <= 20; i++) {
            double x = 4 - 0.4 * i;
            xy[2 * i] = x;
            xy[2 * i + 1] = 0.15 * x * x;
        }
        pool.add(BodyDefinition.fixed(Chain.open(xy)));
        pool.add(
                BodyDefinition.dynamic(new Circle(0.5))
                        .at(-3, 3)
                        .material(new Material(1, 0.4, 0)));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (ContactEvent contact : pool.contactEvents()) {
            sketch.point(contact.x(), contact.y(), Sketch.Tone.BAD);
            sketch.line(
                    contact.x(),
                    contact.y(),
                    contact.x() - 0.5 * contact.normalX(),
                    contact.y() - 0.5 * contact.normalY(),
                    Sketch.Tone.GOOD);
        }
    }

    @Override
    public View view() {
        return new View(0, 2, 9);
    }
}

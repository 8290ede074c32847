package rigibo.samples.dyn4j;

import rigibo.backend.ContactEvent;
import rigibo.backend.Pool;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Each contact from its begin to its end: points that persist. */
public final class TrackedContacts implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.dynamic(new Capsule(0.6, 0.3)).at(-2.4, 2).angle(0.6).spin(4));
        pool.add(BodyDefinition.dynamic(Polygon.regular(5, 0.6)).at(0, 3).spin(-3));
        pool.add(
                BodyDefinition.dynamic(
                                Compound.of(
                                        Part.of(Polygon.box(1.6, 0.3)),
                                        Part.of(new Circle(0.35)).at(0.8, 0)))
                        .at(2.4, 2.6));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (ContactEvent contact : pool.contactEvents()) {
            boolean isOld = contact.phase() == ContactEvent.Phase.PERSIST;
            sketch.point(contact.x(), contact.y(), isOld ? Sketch.Tone.GOOD : Sketch.Tone.BAD);
        }
    }

    @Override
    public View view() {
        return new View(0, 2, 8);
    }
}

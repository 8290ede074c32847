package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Parts far from the origin of their frame: the body is where its mass is. */
public final class OffsetShapes implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        Compound far =
                Compound.of(
                        Part.of(Polygon.box(1, 1)).at(20, 20),
                        Part.of(new Capsule(0.5, 0.2)).at(20, 20.7));
        for (int i = 0; i < 4; i++) {
            pool.add(BodyDefinition.dynamic(far).at(-2.4 + 1.6 * i, 1 + 0.5 * i).angle(0.3 * i));
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (RigidBody body : pool.bodies()) {
            sketch.point(body.x(), body.y(), Sketch.Tone.GOOD);
        }
    }

    @Override
    public View view() {
        return new View(0, 2.4, 9);
    }
}

package rigibo.samples.box2d;

import rigibo.backend.Explosion;
import rigibo.backend.Pool;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A low centre of mass stands it up again; the right button blasts. */
public final class Weeble implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        Compound body =
                Compound.of(Part.of(new Capsule(0.6, 0.5)).angle(Math.PI / 2)).centredAt(0, -0.75);
        for (int i = 0; i < 3; i++) {
            pool.add(
                    BodyDefinition.dynamic(body)
                            .at(-2.4 + 2.4 * i, 0.4)
                            .angle(0.9 - 0.4 * i)
                            .material(new Material(2, 0.6, 0)));
        }
    }

    @Override
    public void act(Pool pool, double x, double y) {
        pool.explode(Explosion.at(x, y).radius(2).falloff(1).impulsePerMetre(6));
    }

    @Override
    public View view() {
        return new View(0, 2, 8);
    }
}

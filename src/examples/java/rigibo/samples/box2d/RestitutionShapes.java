package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Balls of elasticity 0 to 1 return to e² of their height. */
public final class RestitutionShapes implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        for (int i = 0; i <= 10; i++) {
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.25))
                            .at(-3.5 + 0.7 * i, 5)
                            .material(new Material(1, 0, i / 10.0)));
        }
    }

    /** Where a ball comes up to after its first bounce. */
    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (int i = 0; i <= 10; i++) {
            double top = 0.25 + i * i / 100.0 * 4.75;
            sketch.line(-3.75 + 0.7 * i, top, -3.25 + 0.7 * i, top, Sketch.Tone.GOOD);
        }
    }

    @Override
    public Effects effects() {
        return Effects.usual().without(Sleep.class);
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}

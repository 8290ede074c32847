package rigibo.samples.box2d;

import rigibo.backend.Explosion;
import rigibo.backend.Pool;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Bodies that fell asleep are marked; the right button blasts. */
public final class BodyMove implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(-4.25, 4));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(4.25, 4));
        for (int i = 0; i < 40; i++) {
            Shape shape =
                    i % 3 == 0
                            ? new Circle(0.25)
                            : i % 3 == 1
                                    ? new Capsule(0.25, 0.18)
                                    : Polygon.box(0.4, 0.4).rounded(0.05);
            pool.add(
                    BodyDefinition.dynamic(shape)
                            .at(-3 + 0.85 * (i % 8), 0.6 + 0.9 * (i / 8))
                            .angle(i));
        }
    }

    @Override
    public void act(Pool pool, double x, double y) {
        pool.explode(Explosion.at(x, y).radius(2).falloff(2).impulsePerMetre(4));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        pool.bodies().stream()
                .filter(body -> body.type() == BodyType.DYNAMIC && !body.isAwake())
                .forEach(body -> sketch.point(body.x(), body.y(), Sketch.Tone.GOOD));
    }

    @Override
    public View view() {
        return new View(0, 3.4, 10);
    }
}

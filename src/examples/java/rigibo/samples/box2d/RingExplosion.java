package rigibo.samples.box2d;

import rigibo.backend.Explosion;
import rigibo.backend.Pool;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Slats in a ring are blown outwards every three seconds. */
public final class RingExplosion implements Exhibit {
    private int count;

    @Override
    public void build(Pool pool) {

        for (int i = 0; i < 36; i++) {
            double angle = Math.PI * i / 18;
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.3, 0.5))
                            .at(2.2 * Angle.cos(angle), 2.2 * Angle.sin(angle))
                            .angle(angle)
                            .material(new Material(1, 0.3, 0.2).drag(0.6)));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        int due = (int) ((pool.time() + 2) / 3);
        if (due > count) {
            count = due;
            act(pool, 0, 0);
        }
    }

    @Override
    public void act(Pool pool, double x, double y) {
        pool.explode(
                Explosion.at(x, y).radius(2.5).falloff(1).impulsePerMetre(count % 2 == 1 ? 1 : -1));
    }

    @Override
    public Effects effects() {
        return Effects.usual().without(Gravity.class).with(new Drag());
    }

    @Override
    public View view() {
        return new View(0, 0, 11);
    }
}

package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Each edge runs at a speed of its own and carries the bodies on it. */
public final class TangentSpeed implements Exhibit {
    private static final Material BELT = new Material(1, 0.8, 0);

    @Override
    public void build(Pool pool) {

        Chain course = Chain.open(4, 1.5, 3.8, 0, 1.5, 0, -0.5, 0.8, -2.5, 0.8, -3.8, 0, -4, 3);
        BodyDefinition body = BodyDefinition.fixed(course);
        for (int edge = 1; edge < 5; edge++) {
            body = body.material(edge, BELT.surfaceSpeed(edge == 1 ? 2 : -1.5));
        }
        pool.add(body);
        for (int i = 0; i < 12; i++) {
            pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(-3.2 + 0.5 * i, 3 + 0.1 * i));
        }
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new SurfaceSpeed());
    }

    @Override
    public View view() {
        return new View(0, 2, 9);
    }
}

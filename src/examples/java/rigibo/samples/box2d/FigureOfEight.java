package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A driven box moves along a figure of eight and pushes the bodies in its way. */
public final class FigureOfEight implements Exhibit {
    private static final double DT = 1.0 / 60;
    private RigidBody driven;

    @Override
    public void build(Pool pool) {

        driven = pool.add(BodyDefinition.kinematic(Polygon.box(0.3, 1.2)));
        for (int i = 0; i < 40; i++) {
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.15))
                            .at(-3.4 + 0.75 * (i % 10), -1.5 + i / 10)
                            .material(new Material(1, 0.5, 0.2).drag(1)));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        double t = pool.time() + DT;
        double x = 3 * Angle.sin(t);
        double y = 1.5 * Angle.sin(2 * t);
        driven.velocity((x - driven.x()) / DT, (y - driven.y()) / DT);
        driven.spin((t - driven.angle()) / DT);
    }

    @Override
    public Effects effects() {
        return Effects.usual().without(Gravity.class).with(new Drag());
    }

    @Override
    public View view() {
        return new View(0, 0, 9);
    }
}

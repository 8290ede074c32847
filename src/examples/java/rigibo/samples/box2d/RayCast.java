package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Rays from all sides at one shape after the other, with normals. */
public final class RayCast implements Exhibit {
    private RigidBody target;

    @Override
    public void build(Pool pool) {

        target = pool.add(BodyDefinition.kinematic(Polygon.box(2, 1).rounded(0.3)).spin(0.4));
        pool.add(BodyDefinition.fixed(new Circle(0.6)).at(-3, 2));
        pool.add(BodyDefinition.fixed(new Capsule(0.7, 0.3)).at(3, -2));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (int i = 0; i < 24; i++) {
            double angle = Math.PI * i / 12;
            double x = 4.4 * Angle.cos(angle);
            double y = 4.4 * Angle.sin(angle);
            pool.rayCast(x, y, target.x(), target.y())
                    .ifPresent(
                            hit -> {
                                sketch.line(x, y, hit.x(), hit.y(), Sketch.Tone.PLAIN);
                                sketch.line(
                                        hit.x(),
                                        hit.y(),
                                        hit.x() + 0.4 * hit.normalX(),
                                        hit.y() + 0.4 * hit.normalY(),
                                        Sketch.Tone.GOOD);
                                sketch.point(hit.x(), hit.y(), Sketch.Tone.BAD);
                            });
        }
    }

    @Override
    public Effects effects() {
        return Effects.of(new Rotation());
    }

    @Override
    public View view() {
        return new View(0, 0, 12);
    }
}

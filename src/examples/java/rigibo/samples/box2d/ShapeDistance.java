package rigibo.samples.box2d;

import rigibo.backend.Geometry;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.ShapeGap;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.Locale;

/** The nearest points of two shapes, without a pool. */
public final class ShapeDistance implements Exhibit {
    private RigidBody moving;
    private RigidBody still;

    @Override
    public void build(Pool pool) {

        still = pool.add(BodyDefinition.fixed(Polygon.regular(5, 1.2)).at(0, 0));
        moving = pool.add(BodyDefinition.kinematic(new Capsule(0.8, 0.3)).at(3, 0).spin(0.7));
    }

    @Override
    public void beforeStep(Pool pool) {
        moving.velocity(-2.2 * Angle.sin(0.8 * pool.time()), 2.2 * Angle.cos(0.8 * pool.time()));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        ShapeGap gap = Geometry.gap(still.shape(), at(still), moving.shape(), at(moving));
        sketch.line(gap.x(), gap.y(), gap.otherX(), gap.otherY(), Sketch.Tone.GOOD);
        sketch.point(gap.x(), gap.y(), Sketch.Tone.PLAIN);
        sketch.point(gap.otherX(), gap.otherY(), Sketch.Tone.PLAIN);
        sketch.count(String.format(Locale.ROOT, "%.3f m", gap.gap()));
    }

    private static Placement at(RigidBody body) {
        return new Placement(body.x(), body.y(), body.angle());
    }

    @Override
    public Effects effects() {
        return Effects.of(new Rotation());
    }

    @Override
    public View view() {
        return new View(0, 0, 10);
    }
}

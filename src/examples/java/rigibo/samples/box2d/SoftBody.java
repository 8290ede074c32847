package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A ring of capsules, softly welded, that rolls and gives way. */
public final class SoftBody implements Exhibit {

    private static final int SIDES = 12;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(4, 0.4)).at(-1.5, 2.2).angle(-0.4));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 2)).at(4, 1));
        double radius = 1;
        double half = radius * Angle.sin(Math.PI / SIDES);
        RigidBody[] ring = new RigidBody[SIDES];
        for (int i = 0; i < SIDES; i++) {
            double angle = 2 * Math.PI * i / SIDES;
            ring[i] =
                    pool.add(
                            BodyDefinition.dynamic(new Capsule(half - 0.08, 0.14))
                                    .at(
                                            -2 + radius * Angle.cos(angle),
                                            5 + radius * Angle.sin(angle))
                                    .angle(angle + Math.PI / 2)
                                    .material(new Material(100, 0.6, 0)));
        }
        double corner = radius / Angle.cos(Math.PI / SIDES);
        for (int i = 0; i < SIDES; i++) {
            double angle = 2 * Math.PI * (i + 0.5) / SIDES;
            double x = -2 + corner * Angle.cos(angle);
            double y = 5 + corner * Angle.sin(angle);
            pool.join(WeldJoint.at(ring[i], ring[(i + 1) % SIDES], x, y).spring(15, 0.3));
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 9);
    }
}

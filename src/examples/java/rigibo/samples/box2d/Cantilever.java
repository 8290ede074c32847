package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Eight boxes welded in a row to a wall bend under their weight, stiff above and soft below. */
public final class Cantilever implements Exhibit {

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody wall = pool.add(BodyDefinition.fixed(Polygon.box(0.4, 7)).at(-4, 3.5));
        beam(pool, wall, 5.5, 0);
        beam(pool, wall, 3.5, 45);
        beam(pool, wall, 1.8, 30);
    }

    /** Springs of a frequency in Hz, or none. */
    private static void beam(Pool pool, RigidBody wall, double y, double hertz) {
        RigidBody before = wall;
        for (int i = 0; i < 8; i++) {
            double x = -3.8 + 0.8 * i;
            RigidBody piece =
                    pool.add(
                            BodyDefinition.dynamic(new Capsule(0.3, 0.1))
                                    .at(x + 0.4, y)
                                    .material(new Material(20, 0.5, 0)));
            WeldJoint rigid = WeldJoint.at(before, piece, x, y);
            pool.join(hertz > 0 ? rigid.spring(hertz, 0.7) : rigid);
            before = piece;
        }
    }

    @Override
    public View view() {
        return new View(0, 3.2, 9);
    }
}

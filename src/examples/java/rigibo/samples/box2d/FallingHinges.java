package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Columns of boxes, each hinged to its neighbour, fold as they fall: the same way each time. */
public final class FallingHinges implements Exhibit {

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        for (int column = 0; column < 3; column++) {
            RigidBody before = null;
            for (int row = 0; row < 8; row++) {
                double x = 2.2 * (column - 1) + (row % 2 == 0 ? 0.12 : -0.12);
                double y = 0.6 + 0.52 * row;
                RigidBody box =
                        pool.add(
                                BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                        .at(x, y)
                                        .angle(0.05 * row - 0.1));
                if (row % 2 == 1) {
                    pool.join(
                            RevoluteJoint.at(before, box, x + 0.12, y - 0.26)
                                    .limits(-0.3, 0.6)
                                    .spring(0.5, 0.5)
                                    .collideConnected(true));
                }
                before = box;
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}

package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Two wheels on bars that slide against each other: it folds and unfolds as it falls. */
public final class Doohickey implements Exhibit {

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
        for (int i = 0; i < 4; i++) {
            gadget(pool, 1.2 * (i - 1.5), 2.5 + 1.2 * i);
        }
    }

    private static void gadget(Pool pool, double x, double y) {
        RigidBody left = pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(x - 1.5, y).mass(3));
        RigidBody right = pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(x + 1.5, y).mass(3));
        RigidBody one = pool.add(bar(x - 0.8, y));
        RigidBody other = pool.add(bar(x + 0.8, y));
        pool.join(RevoluteJoint.at(left, one, x - 1.5, y).motor(0, 2));
        pool.join(RevoluteJoint.at(right, other, x + 1.5, y).motor(0, 2));
        pool.join(PrismaticJoint.along(one, other, x, y, 0).limits(-0.6, 0.6).motor(0, 5));
    }

    private static BodyDefinition bar(double x, double y) {
        return BodyDefinition.dynamic(new Capsule(0.6, 0.08)).at(x, y).mass(1);
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}

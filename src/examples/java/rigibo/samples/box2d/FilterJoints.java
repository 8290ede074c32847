package rigibo.samples.box2d;

import rigibo.backend.FilterJoint;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;

/** Two boxes that never meet each other stand in one place on the same floor. */
public final class FilterJoints implements Exhibit {

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
        RigidBody one = pool.add(BodyDefinition.dynamic(Polygon.box(1.4, 1.4)).at(-0.4, 3));
        RigidBody other = pool.add(BodyDefinition.dynamic(Polygon.box(1.4, 1.4)).at(0.4, 5));
        pool.join(new FilterJoint(one, other));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 7.5));
    }
}

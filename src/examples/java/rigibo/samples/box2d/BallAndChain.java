package rigibo.samples.box2d;

import rigibo.backend.Pool;
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

/** A heavy ball at the end of thirty light links. */
public final class BallAndChain implements Exhibit {

    private static final int LINKS = 30;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody hook = pool.add(BodyDefinition.fixed(Polygon.box(1, 0.2)).at(0, 7).group(1));
        RigidBody before = hook;
        for (int i = 0; i < LINKS; i++) {
            RigidBody link =
                    pool.add(
                            BodyDefinition.dynamic(new Capsule(0.09, 0.04))
                                    .at(0.09 + 0.18 * i, 7)
                                    .group(1)
                                    .mass(0.5));
            pool.join(RevoluteJoint.at(before, link, 0.18 * i, 7).motor(0, 0.05));
            before = link;
        }
        double end = 0.18 * LINKS;
        RigidBody ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.6))
                                .at(end + 0.6, 7)
                                .mass(500)
                                .group(1));
        pool.join(RevoluteJoint.at(before, ball, end, 7));
    }

    @Override
    public View view() {
        return new View(0, 3.5, 16);
    }
}

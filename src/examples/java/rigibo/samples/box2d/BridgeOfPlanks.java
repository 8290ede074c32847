package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Forty planks from pillar to pillar, and what falls on them. */
public final class BridgeOfPlanks implements Exhibit {

    private static final int PLANKS = 40;
    private static final double LENGTH = 0.42;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        double half = 0.2 * PLANKS;
        RigidBody left = pool.add(BodyDefinition.fixed(Polygon.box(1, 6)).at(-half - 0.5, 3));
        RigidBody right = pool.add(BodyDefinition.fixed(Polygon.box(1, 6)).at(half + 0.5, 3));
        RigidBody before = left;
        double lean = Angle.acos(0.4 / LENGTH);
        double x = -half;
        double y = 5.9;
        for (int i = 0; i < PLANKS; i++) {
            double angle = i < PLANKS / 2 ? -lean : lean;
            double dx = LENGTH * Angle.cos(angle);
            double dy = LENGTH * Angle.sin(angle);
            RigidBody plank =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(LENGTH, 0.12))
                                    .at(x + dx / 2, y + dy / 2)
                                    .angle(angle));
            pool.join(RevoluteJoint.at(before, plank, x, y).motor(0, 20));
            before = plank;
            x += dx;
            y += dy;
        }
        pool.join(RevoluteJoint.at(before, right, x, y).motor(0, 20));
    }

    @Override
    public void act(Pool pool, double x, double y) {
        pool.add(BodyDefinition.dynamic(Polygon.regular(3, 0.4)).at(x, y));
    }

    @Override
    public View view() {
        return new View(0, 4, 20);
    }
}

package rigibo.examples;

import rigibo.backend.Joint;
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

import java.util.ArrayList;
import java.util.List;

/** A bridge of planks hangs in the curve of its own weight, and crates ride it. */
public final class HangingBridge implements Exhibit {

    static final double HALF = 5; // m
    private static final int PLANKS = 20;
    private static final double LENGTH = 0.53; // m

    /** Joints from left to right. */
    final List<Joint> joints = new ArrayList<>();

    /** Horizontal pull in the bridge over the weight of a plank. */
    double pull;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody left = pool.add(BodyDefinition.fixed(Polygon.box(3, 2)).at(-HALF - 1.5, 2));
        RigidBody right = pool.add(BodyDefinition.fixed(Polygon.box(3, 2)).at(HALF + 1.5, 2));
        pull = pull();
        RigidBody before = left;
        double x = -HALF;
        double y = 2.95;
        for (int k = 1; k <= PLANKS; k++) {
            double angle = lean(k, pull);
            double dx = LENGTH * Angle.cos(angle);
            double dy = LENGTH * Angle.sin(angle);
            RigidBody plank =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(LENGTH, 0.1))
                                    .at(x + dx / 2, y + dy / 2)
                                    .angle(angle));
            joints.add(pool.join(RevoluteJoint.at(before, plank, x, y)));
            before = plank;
            x += dx;
            y += dy;
        }
        joints.add(pool.join(RevoluteJoint.at(before, right, x, y)));
    }

    /** Plank k of n: tan θ = (2k − n − 1)/(2H), where H is the pull over a plank's weight. */
    private static double lean(int plank, double pull) {
        return Angle.atan2(2 * plank - PLANKS - 1, 2 * pull);
    }

    /** The pull at which the planks span the gap, by bisection. */
    private static double pull() {
        double low = 0.1;
        double high = 100;
        for (int i = 0; i < 60; i++) {
            double middle = (low + high) / 2;
            double span = 0;
            for (int k = 1; k <= PLANKS; k++) {
                span += LENGTH * Angle.cos(lean(k, middle));
            }
            low = span < 2 * HALF ? middle : low;
            high = span < 2 * HALF ? high : middle;
        }
        return high;
    }

    @Override
    public void act(Pool pool, double x, double y) {
        pool.add(BodyDefinition.dynamic(Polygon.box(0.6, 0.6)).at(x, y));
    }

    @Override
    public View view() {
        return new View(0, 2.5, 13);
    }
}

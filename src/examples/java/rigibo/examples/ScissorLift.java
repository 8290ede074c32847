package rigibo.examples;

import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Crossed bars raise a table: a slide at the foot pulls them together. */
public final class ScissorLift implements Exhibit {

    static final double BAR = 2.4; // m, between the pins at its ends
    static final int STOREYS = 3;
    static final double LEAN = 0.35; // rad, at the beginning

    RigidBody table;
    RigidBody firstBar;
    Joint slide;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.55).group(1));
        double half = BAR / 2 * Angle.cos(LEAN);
        double rise = BAR * Angle.sin(LEAN);
        RigidBody foot = pool.add(block(0.3, 0.2, half, 0));
        slide = pool.join(PrismaticJoint.along(floor, foot, half, 0, 0).limits(-1.6, 0.1));
        RigidBody left = floor;
        RigidBody right = foot;
        for (int i = 0; i < STOREYS; i++) {
            double y = (i + 0.5) * rise;
            RigidBody rising = pool.add(block(BAR + 0.16, 0.12, 0, y).angle(LEAN));
            RigidBody falling = pool.add(block(BAR + 0.16, 0.12, 0, y).angle(-LEAN));
            firstBar = i == 0 ? rising : firstBar;
            pool.join(RevoluteJoint.at(left, rising, -half, i * rise));
            pool.join(RevoluteJoint.at(right, falling, half, i * rise));
            pool.join(RevoluteJoint.at(rising, falling, 0, y));
            left = falling;
            right = rising;
        }
        table = pool.add(block(3, 0.16, 0, STOREYS * rise + 0.1));
        pool.join(RevoluteJoint.at(left, table, -half, STOREYS * rise));
        pool.join(
                PrismaticJoint.along(
                        table,
                        pool.add(block(0.2, 0.1, half, STOREYS * rise)),
                        half,
                        STOREYS * rise,
                        0));
        RigidBody shoe = pool.bodies().get(pool.bodies().size() - 1);
        pool.join(RevoluteJoint.at(right, shoe, half, STOREYS * rise));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.6, 0.6)).at(0.2, STOREYS * rise + 0.48));
    }

    private static BodyDefinition block(double width, double height, double x, double y) {
        return BodyDefinition.dynamic(Polygon.box(width, height)).at(x, y).group(1);
    }

    /** Up for four seconds, down for four. */
    @Override
    public void beforeStep(Pool pool) {
        slide.motor(pool.time() % 8 < 4 ? -0.2 : 0.2, 1e5);
    }

    @Override
    public View view() {
        return new View(0, 2.6, 9);
    }
}

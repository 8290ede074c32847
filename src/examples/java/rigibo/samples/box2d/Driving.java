package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WheelJoint;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A car on hills, over a bridge of planks and a see-saw. */
public final class Driving implements Exhibit {

    private RigidBody car;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        double[] xy = new double[2 * 61];
        for (int i = 0; i <= 60; i++) {
            double x = 12 - 0.5 * i;
            xy[2 * i] = x;
            xy[2 * i + 1] = x < 4 ? 0.4 * Angle.sin(x) : 0.4 * Angle.sin(4);
        }
        RigidBody road =
                pool.add(BodyDefinition.fixed(Chain.open(xy)).material(new Material(1, 0.9, 0)));
        RigidBody saw =
                pool.add(BodyDefinition.dynamic(Polygon.box(3, 0.15)).at(6.5, 0.1).mass(40));
        pool.join(RevoluteJoint.at(road, saw, 6.5, 0.1).limits(-0.25, 0.25));
        double x = -8;
        double y = 0.4 * Angle.sin(x) + 1.3;
        car = pool.add(BodyDefinition.dynamic(Polygon.box(2, 0.4)).at(x, y).mass(200));
        for (int side = -1; side <= 1; side += 2) {
            double at = x + 0.7 * side;
            RigidBody wheel =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(0.35))
                                    .at(at, y - 0.35)
                                    .mass(10)
                                    .material(new Material(1, 1.2, 0)));
            WheelJoint strut = WheelJoint.at(car, wheel, at, y - 0.35, Math.PI / 2);
            pool.join(strut.limits(-0.25, 0.25).spring(8, 0.7).motor(-6, 150));
        }
    }

    @Override
    public View view() {
        return new View(0, 2, 16);
    }
}

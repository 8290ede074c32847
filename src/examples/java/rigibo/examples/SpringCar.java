package rigibo.examples;

import rigibo.backend.Joint;
import rigibo.backend.Pool;
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

/** A car on two struts, one wheel driven, on hills. */
public final class SpringCar implements Exhibit {

    RigidBody chassis;
    RigidBody wheel;
    Joint rear;
    Joint front;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        double[] xy = new double[2 * 121];
        for (int i = 0; i <= 120; i++) {
            double x = 30 - 0.5 * i;
            xy[2 * i] = x;
            xy[2 * i + 1] = x > 0 ? 0.5 * (1 - Angle.cos(0.6 * x)) : 0;
        }
        pool.add(BodyDefinition.fixed(Chain.open(xy)).material(new Material(1, 0.9, 0)));
        Polygon hull = Polygon.of(-1, -0.2, 1, -0.2, 1, 0.05, 0.4, 0.35, -0.6, 0.35, -1, 0.1);
        chassis = pool.add(BodyDefinition.dynamic(hull).at(-4, 0.75).mass(200));
        rear = strut(pool, -0.7, -5, 150);
        front = strut(pool, 0.7, 0, 0);
    }

    private Joint strut(Pool pool, double along, double speed, double torque) {
        double x = chassis.x() + along;
        wheel =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.35))
                                .at(x, 0.35)
                                .mass(10)
                                .material(new Material(1, 0.9, 0)));
        WheelJoint strut = WheelJoint.at(chassis, wheel, x, 0.35, Math.PI / 2);
        return pool.join(strut.limits(-0.25, 0.25).spring(8, 0.7).motor(speed, torque));
    }

    @Override
    public View view() {
        return new View(2, 1, 10);
    }
}

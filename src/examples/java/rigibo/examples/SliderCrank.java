package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A crank at an even speed moves a piston by a rod, and the piston throws a ball up. */
public final class SliderCrank implements Exhibit {

    static final double CRANK = 0.8; // m
    static final double ROD = 2.2; // m
    static final double SPEED = 4; // rad/s

    RigidBody crank;
    RigidBody piston;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        RigidBody frame = pool.add(BodyDefinition.fixed(Polygon.box(3, 0.3)).at(0, -1.4).group(1));
        pool.add(BodyDefinition.fixed(Polygon.box(0.2, 4)).at(-0.72, 4.2));
        pool.add(BodyDefinition.fixed(Polygon.box(0.2, 4)).at(0.72, 4.2));
        crank = pool.add(bar(CRANK, 0, CRANK / 2).angle(Math.PI / 2));
        RigidBody rod = pool.add(bar(ROD, 0, CRANK + ROD / 2).angle(Math.PI / 2));
        piston =
                pool.add(BodyDefinition.dynamic(Polygon.box(1.1, 0.5)).at(0, CRANK + ROD).group(1));
        pool.join(RevoluteJoint.at(frame, crank, 0, 0).motor(SPEED, 1e5));
        pool.join(RevoluteJoint.at(crank, rod, 0, CRANK));
        pool.join(RevoluteJoint.at(rod, piston, 0, CRANK + ROD));
        pool.join(PrismaticJoint.along(frame, piston, 0, CRANK + ROD, Math.PI / 2));
        crank.spin(SPEED);
        pool.add(
                BodyDefinition.dynamic(new Circle(0.35))
                        .at(0, CRANK + ROD + 0.61)
                        .material(new Material(50, 0.3, 0)));
    }

    private static BodyDefinition bar(double length, double x, double y) {
        return BodyDefinition.dynamic(Polygon.box(length + 0.2, 0.2)).at(x, y).group(1);
    }

    @Override
    public View view() {
        return new View(0, 2.4, 10);
    }
}

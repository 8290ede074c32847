package rigibo.examples;

import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.Pool;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A motor turns four sails; toothed wheels turn a millstone against them at half the speed. */
public final class Windmill implements Exhibit {

    static final double TORQUE = 300; // N·m
    static final double SPEED = 1.5; // rad/s
    static final double RATIO = 2;

    RigidBody sails;
    RigidBody stone;
    Joint axle;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints());
    }

    @Override
    public void build(Pool pool) {
        Polygon tower = Polygon.of(-1.4, 0, 1.4, 0, 0.5, 5, -0.5, 5);
        RigidBody mill = pool.add(BodyDefinition.fixed(tower).at(0, tower.centroidY()).group(1));
        Part hub = Part.of(new Circle(0.4));
        Part sail = Part.of(Polygon.box(1.9, 0.3));
        double quarter = Math.PI / 2;
        Compound cross =
                Compound.of(
                        hub,
                        sail.at(1.3, 0),
                        sail.at(0, 1.3).angle(quarter),
                        sail.at(-1.3, 0),
                        sail.at(0, -1.3).angle(quarter));
        sails = pool.add(BodyDefinition.dynamic(cross).at(0, 4.4).group(1));
        stone = pool.add(BodyDefinition.dynamic(new Circle(0.9)).at(0, 3).group(1));
        axle = pool.join(RevoluteJoint.at(mill, sails, 0, 4.4).motor(-SPEED, TORQUE));
        Joint spindle = pool.join(RevoluteJoint.at(mill, stone, 0, 3));
        pool.join(GearJoint.of(axle, spindle, RATIO));
        pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
    }

    @Override
    public View view() {
        return new View(0, 3.2, 9);
    }
}

package rigibo.samples.box2d;

import rigibo.backend.DistanceJoint;
import rigibo.backend.JointDefinition;
import rigibo.backend.Pool;
import rigibo.backend.PrismaticJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** Each kind of joint carries a load that grows, until it gives way. */
public final class BreakableJoints implements Exhibit {

    private final List<RigidBody> loads = new ArrayList<>();
    private int broken;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Joints()).with(new Thrust());
    }

    @Override
    public void build(Pool pool) {
        RigidBody beam = pool.add(BodyDefinition.fixed(Polygon.box(9, 0.4)).at(0, 5));
        pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
        for (int i = 0; i < 5; i++) {
            double x = 1.6 * (i - 2);
            RigidBody load =
                    pool.add(BodyDefinition.dynamic(Polygon.box(0.8, 0.8)).at(x, 3).mass(10));
            loads.add(load);
            JointDefinition joint =
                    switch (i) {
                        case 0 -> DistanceJoint.rod(beam, x, 4.8, load, x, 3.4);
                        case 1 -> RevoluteJoint.at(beam, load, x, 3.4);
                        case 2 -> PrismaticJoint.along(beam, load, x, 3, 0);
                        case 3 -> WeldJoint.at(beam, load, x, 3.4);
                        default -> WheelJoint.at(beam, load, x, 3, 0);
                    };
            pool.join(joint.breaking(200 + 100 * i, Double.POSITIVE_INFINITY));
        }
    }

    /** Pulls each load by another 100 N each second. */
    @Override
    public void beforeStep(Pool pool) {
        broken += pool.brokenJoints().size();
        for (RigidBody load : loads) {
            load.applyForce(0, -100 * pool.time(), load.x(), load.y());
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count("" + broken);
    }

    @Override
    public View view() {
        return new View(0, 2.6, 9);
    }
}

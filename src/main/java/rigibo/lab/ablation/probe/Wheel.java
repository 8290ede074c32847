package rigibo.lab.ablation.probe;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/** Wheels that roll down a ramp each, driven by a torque and held back by a thrust. */
final class Wheel implements Workload {

    private static final int WHEELS = 20;
    private static final double RADIUS = 0.45;
    private static final double SLOPE = -Math.toRadians(15);
    private static final double TORQUE = -5;
    private static final double THRUST = -10;

    /** Between one ramp and the next below it, m. */
    private static final double STOREY = 12;

    private static final Material RUBBER = new Material(1, 0.6, 0).rollingResistance(0.005);

    @Override
    public String name() {
        return "wheel";
    }

    @Override
    public String words() {
        return "20 wheels rolling down a ramp each under torque and thrust";
    }

    @Override
    public Effects effects() {
        return Effects.of(
                new Gravity(0, -9.81),
                new Contacts(),
                new Rotation(),
                new Friction(),
                new RollingResistance(),
                new Thrust(),
                new ContinuousImpacts());
    }

    /** The wheels first, so that they are found by their number. */
    @Override
    public List<BodyDefinition> bodies() {
        List<BodyDefinition> bodies = new ArrayList<>();
        double along = -3.4;
        double above = 0.3 + RADIUS;
        double x = along * Math.cos(SLOPE) - above * Math.sin(SLOPE);
        double y = along * Math.sin(SLOPE) + above * Math.cos(SLOPE);
        for (int i = 0; i < WHEELS; i++) {
            bodies.add(
                    BodyDefinition.dynamic(new Circle(RADIUS))
                            .at(x, y - STOREY * i)
                            .mass(10)
                            .material(RUBBER));
        }
        for (int i = 0; i < WHEELS; i++) {
            bodies.add(
                    BodyDefinition.fixed(Polygon.box(30, 0.6))
                            .at(0, -STOREY * i)
                            .angle(SLOPE)
                            .material(RUBBER.rollingResistance(0)));
        }
        return bodies;
    }

    @Override
    public int stepsToSettle() {
        return 5;
    }

    @Override
    public int period() {
        return 90;
    }

    @Override
    public void drive(Pool pool) {
        for (int i = 0; i < WHEELS; i++) {
            RigidBody wheel = pool.bodies().get(i);
            wheel.applyTorque(TORQUE);
            wheel.applyForce(THRUST, 0, wheel.x(), wheel.y());
        }
    }
}

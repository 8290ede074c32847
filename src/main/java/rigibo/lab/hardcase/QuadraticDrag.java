package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;

/**
 * Truth: v′ = g − g·v²/v_t² from rest gives v = v_t·tanh(gt/v_t) and y = (v_t²/g)·ln cosh(gt/v_t),
 * with the weight mg = ½·ρ·c·A·v_t². A disc of 1 m and a square of 1 m that falls on a face are as
 * wide as a metre; one that falls on a corner is as wide as its diagonal.
 */
final class QuadraticDrag implements Scenes {

    private static final double TERMINAL = 20;
    private static final double HORIZON = 5;
    private static final double COEFFICIENT = 1.1;

    @Override
    public void run(Trial trial) {
        trial.variant("disc");
        fall(trial, new Circle(0.5), 0, 1);
        trial.variant("box on a face");
        fall(trial, Polygon.box(1, 1), 0, 1);
        trial.variant("box on a corner");
        fall(trial, Polygon.box(1, 1), Math.PI / 4, Math.sqrt(2));
    }

    private static void fall(Trial trial, Shape shape, double angle, double width) {
        double mass = 3;
        double density = 2 * mass * Trial.GRAVITY / (COEFFICIENT * width * TERMINAL * TERMINAL);
        Effects effects =
                Effects.of(new Gravity(0, -Trial.GRAVITY), new AirDrag(density, COEFFICIENT));
        WatchedPool pool = trial.pool(effects);
        RigidBody body = pool.add(BodyDefinition.dynamic(shape).angle(angle).mass(mass));
        for (int i = 1; i <= Math.round(HORIZON / Trial.DT); i++) {
            pool.step();
            double x = Trial.GRAVITY * i * Trial.DT / TERMINAL;
            double v = TERMINAL * Math.tanh(x);
            double way = TERMINAL * TERMINAL / Trial.GRAVITY * Math.log(Math.cosh(x));
            trial.relativeError("speed", -body.velocityY(), v, "relative", 1e-6, 1e-3);
            trial.relativeError("way", -body.y(), way, "relative", 1e-6, 1e-3);
        }
    }
}

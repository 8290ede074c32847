package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Thrust;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Slope;
import rigibo.lab.truth.Solid;

/**
 * Truth on a slope of 20°: ice (μ = 0.03) slides with a = g(sin − μ·cos), rubber (μ = 0.9) holds.
 * Truth for a force F pushing a box of 0.5 × 1.5 at its upper edge: it slides beyond μmg and tips
 * about its lower edge beyond F·h = mg·w/2, F = mg/6. So 0.1 mg moves it on ice and not on rubber,
 * and on rubber 0.4 mg makes it tumble.
 */
final class IceAndRubber implements Scenes {

    private static final double ICE = 0.03;
    private static final double RUBBER = 0.9;
    private static final double ANGLE = Math.toRadians(20);
    private static final double WIDTH = 0.5;
    private static final double HEIGHT = 1.5;

    @Override
    public void run(Trial trial) {
        trial.variant("slope of ice");
        double truth = Trial.GRAVITY * (Math.sin(ANGLE) - ICE * Math.cos(ANGLE));
        double way = wayDown(trial, ICE);
        trial.relativeError("way on ice", way, truth * 9 / 2, "of truth", 1e-4, 1e-2);
        trial.variant("slope of rubber");
        trial.measure("way on rubber", Math.abs(wayDown(trial, RUBBER)), "m", 1e-3);
        trial.variant("0.1 mg on ice");
        RigidBody onIce = push(trial, ICE, 0.1);
        double sliding = (0.1 - ICE) * Trial.GRAVITY * 9 / 2;
        trial.relativeError("way pushed", onIce.x(), sliding, "of truth", 1e-4, 1e-2);
        trial.variant("0.1 mg on rubber");
        RigidBody held = push(trial, RUBBER, 0.1);
        trial.measure("moved though held", Math.abs(held.x()), "m", 1e-3);
        trial.measure("turned though held", Math.abs(held.angle()), "rad", 1e-3);
        trial.variant("0.4 mg on rubber");
        RigidBody tumbled = push(trial, RUBBER, 0.4);
        trial.require("enough force makes it tumble", tumbled.angle() < -1);
    }

    /** The way of a box within 3 s, m. */
    private static double wayDown(Trial trial, double friction) {
        Slope slope = new Slope(ANGLE);
        WatchedPool pool = trial.earth();
        Descent box = new Descent(pool, slope, slope.place(Solid.box(1, 1, friction, 0), 0.5));
        pool.run(3);
        return box.way();
    }

    private static RigidBody push(Trial trial, double friction, double weights) {
        WatchedPool pool = trial.pool(Earth.effects().with(new Thrust()));
        pool.add(Earth.floor(friction, 0));
        RigidBody box = pool.add(Solid.box(WIDTH, HEIGHT, friction, 0).at(0, HEIGHT / 2));
        double force = weights * box.mass() * Trial.GRAVITY;
        for (int i = 0; i < 180 && box.angle() > -1; i++) {
            box.applyForce(force, 0, box.x(), box.y() + HEIGHT / 2);
            pool.step();
        }
        return box;
    }
}

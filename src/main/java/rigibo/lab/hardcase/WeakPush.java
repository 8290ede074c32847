package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * A weak push on a smooth floor. Truth: nothing opposes it without friction, so v = a·t however
 * small a is, and however heavy its neighbour is: the loads of one body must not decide about the
 * rest of another.
 */
final class WeakPush implements Scenes {

    private static final double HORIZON = 5;
    private static final double HEAVY = 1e6;
    private static final Limits MOST_OFF = Limits.of(1e-3, 1e-6);

    private static final BodyDefinition BOX = Solid.box(1, 1, 0, 0);

    @Override
    public void run(Trial trial) {
        List<Double> pushes =
                trial.sampling().of(List.of(1e-6, 1e-3), List.of(1e-6, 1e-5, 1e-4, 1e-3));
        for (double push : pushes) {
            trial.variant("box under sideways gravity of " + push);
            sideways(trial, Polygon.box(1, 1), push);
            trial.variant("disc under sideways gravity of " + push);
            sideways(trial, new Circle(0.5), push);
            trial.variant("box pushed by " + push + " away from a heavy one");
            beside(trial, push, 0);
            trial.variant("box pushed by " + push + " on a raft with a heavy one");
            beside(trial, push, 1);
        }
    }

    private static void sideways(Trial trial, Shape shape, double push) {
        Effects effects = Earth.effects().with(new Gravity(push, -Trial.GRAVITY));
        WatchedPool pool = trial.pool(effects);
        pool.add(Earth.floor(0, 0));
        RigidBody body = pool.add(Solid.of(shape, 0, 0).at(0, 0.5));
        pool.run(HORIZON);
        trial.relativeError("speed", body.velocityX(), push * HORIZON, "of a·t", MOST_OFF);
    }

    /** Pushes a body that touches one of a million times its weight, on a raft or on the floor. */
    private static void beside(Trial trial, double push, double raft) {
        WatchedPool pool = trial.pool(Earth.effects().with(new Thrust())).withOverlapOfItsOwn();
        pool.add(Earth.floor(0, 0));
        if (raft > 0) {
            pool.add(Solid.box(8, raft, 0, 0).at(0, raft / 2));
        }
        double y = raft + 0.5;
        pool.add(BOX.at(-0.5, y).gravityScale(HEAVY));
        RigidBody body = pool.add(BOX.at(0.5, y));
        // Steps are counted, since times add up to a little less than the horizon.
        for (long i = 0; i < Math.round(HORIZON / Trial.DT); i++) {
            body.applyForce(body.mass() * push, 0, body.x(), body.y());
            pool.step();
        }
        trial.relativeError(
                "speed beside a heavy one", body.velocityX(), push * HORIZON, "of a·t", MOST_OFF);
    }
}

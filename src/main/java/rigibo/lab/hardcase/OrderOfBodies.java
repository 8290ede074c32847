package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/**
 * Truth: the laws do not depend on the order in which bodies were added. Ten of twenty bodies meet
 * in five impacts at five different times; the shuffled set must move equally. Shuffling may swap
 * the bodies of a pair, so the last bits may differ.
 */
final class OrderOfBodies implements Scenes {

    private static final int SHUFFLES = 10;
    private static final double HORIZON = 2;

    @Override
    public void run(Trial trial) {
        List<BodyDefinition> bodies = bodies();
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < bodies.size(); i++) {
            order.add(i);
        }
        List<RigidBody> truth = simulate(trial, bodies, order);
        Random random = new Random(9);
        for (int shuffle = 0; shuffle < SHUFFLES; shuffle++) {
            Collections.shuffle(order, random);
            trial.variant("seed 9, shuffle " + shuffle);
            List<RigidBody> again = simulate(trial, bodies, order);
            for (int i = 0; i < order.size(); i++) {
                RigidBody expected = truth.get(order.get(i));
                double off =
                        Math.hypot(
                                again.get(i).x() - expected.x(), again.get(i).y() - expected.y());
                trial.measure("place", off, "m", 1e-9);
            }
        }
    }

    private static List<RigidBody> simulate(
            Trial trial, List<BodyDefinition> bodies, List<Integer> order) {
        WatchedPool pool = trial.earth();
        List<RigidBody> added = new ArrayList<>();
        for (int i : order) {
            added.add(pool.add(bodies.get(i)));
        }
        pool.run(HORIZON);
        return added;
    }

    private static List<BodyDefinition> bodies() {
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            Shape shape = i % 2 == 0 ? new Circle(0.4) : Polygon.box(0.7, 0.5);
            BodyDefinition pattern = Solid.of(shape, 0.3, 0.6);
            double y = 10.0 * i;
            bodies.add(pattern.at(-3 - 0.21 * i, y).velocity(4, 1).angle(0.3 * i));
            bodies.add(pattern.at(3, y + 0.1).velocity(-3, 1).spin(0.5));
            bodies.add(pattern.at(20, y).velocity(1, i));
            bodies.add(pattern.at(40, y).spin(i + 1));
        }
        return bodies;
    }
}

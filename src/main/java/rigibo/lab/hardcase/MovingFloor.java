package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.child.Work;

import java.util.ArrayList;
import java.util.List;

/**
 * A pile that moves with its floor at a constant speed. Truth: the laws are equal in both frames,
 * so the pile behaves as on a floor at rest and takes as much work.
 */
final class MovingFloor implements Scenes {

    private static final List<Double> SPEEDS = List.of(0.5, 5.0, 50.0);
    private static final Limits MOST_OFF = Limits.same(1e-6);
    private static final Limits MOST_WORK = Limits.same(0.05);

    /** The time after which a standing pile is checked again, s. */
    private static final double LATE = 3;

    @Override
    public void run(Trial trial) {
        Piles.some(trial.sampling())
                .forEach(
                        (name, pile) -> {
                            trial.variant(name + " at rest");
                            Course rest = new Course(trial, pile);
                            for (double speed : SPEEDS) {
                                trial.variant(name + " at " + speed + " m/s");
                                compare(trial, rest, new Course(trial, Piles.moving(pile, speed)));
                            }
                        });
    }

    private static void compare(Trial trial, Course rest, Course moving) {
        int second = (int) Math.round(1 / Trial.DT);
        trial.measure("place within 1 s", rest.off(moving, second), "m", MOST_OFF);
        double creep = rest.off(moving, rest.places.size());
        trial.measure("place within 3 s", creep, "m", Limits.NONE);
        if (rest.isStanding()) {
            trial.measure("creeps in 3 s", creep, "m", MOST_OFF);
        }
        double more = Math.abs(moving.work.solved() - rest.work.solved());
        double share = more / Math.max(rest.work.solved(), rest.work.contacts());
        trial.measure("work", share, "of that at rest", MOST_WORK);
    }

    /** The places of all bodies relative to the first, step by step, and the work. */
    private static final class Course {

        private final List<double[]> places = new ArrayList<>();
        private Work work = Work.NONE;

        Course(Trial trial, Scene scene) {
            StagedScene stage = new StagedScene(trial, scene);
            RigidBody floor = stage.bodies().get(0);
            while (stage.pool().time() < LATE) {
                stage.step();
                places.add(against(floor, stage.dynamic()));
                work = work.plus(Work.of(stage.pool().pool().report()));
            }
        }

        private static double[] against(RigidBody floor, List<RigidBody> bodies) {
            double[] place = new double[2 * bodies.size()];
            for (int i = 0; i < bodies.size(); i++) {
                place[2 * i] = bodies.get(i).x() - floor.x();
                place[2 * i + 1] = bodies.get(i).y();
            }
            return place;
        }

        /** Greatest difference of a coordinate before a step, m. */
        double off(Course other, int to) {
            double most = 0;
            for (int step = 0; step < to; step++) {
                double[] others = other.places.get(step);
                most = Math.max(most, Places.farthestApart(places.get(step), others));
            }
            return most;
        }

        /** Whether nothing moves. */
        boolean isStanding() {
            double[] last = places.get(places.size() - 1);
            return Places.farthestApart(places.get(0), last) < MOST_OFF.exact();
        }
    }
}

package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Solid;

import java.util.List;
import java.util.SplittableRandom;

/**
 * A rolling disc meets a step, h/r < ¼, e = 0, μ = 2. Truth: the angular momentum about the step's
 * corner is kept, ω′·(3/2)·m·r² = ω·(½·m·r² + m·r·(r − h)), so ω′ = ω·(1 − 2h/3r). Then the disc
 * turns about the corner, ¾·m·v² against m·g·h: it climbs if v > √(4gh/3)/(1 − 2h/3r), and goes on
 * above at √(v′² − 4gh/3).
 */
final class StepClimb implements Scenes {

    private static final List<Double> FEW = List.of(0.07, 0.21);
    private static final List<Double> ALL = List.of(0.02, 0.05, 0.07, 0.1, 0.13, 0.17, 0.21, 0.245);
    private static final double FRICTION = 2;
    private static final double PATIENCE = 5;

    /** Distance from the least climbing speed within which either outcome is right. */
    private static final Limits UNDECIDED = new Limits(0.02, 0.02, 0.005);

    /** A share of the least speed that surely climbs, and at which the disc stays on the corner. */
    private static final double SURE = 1.25;

    @Override
    public void run(Trial trial) {
        int phases = trial.sampling().count(4, 20);
        double off = UNDECIDED.of(trial.preset());
        int wrong = 0;
        int tried = 0;
        for (double share : trial.sampling().of(FEW, ALL)) {
            for (int phase = 0; phase < phases; phase++) {
                SplittableRandom random = trial.sampling().random(Math.round(1e6 * share) + phase);
                double radius = 0.2 + random.nextDouble();
                double away = radius + 0.5 + random.nextDouble();
                trial.variant("h/r " + share + ", r " + radius + ", from " + away + " m");
                Climb climb = new Climb(radius, share * radius, away);
                wrong += climb.isAbove(trial, 1 - off) ? 1 : 0;
                wrong += climb.isAbove(trial, 1 + off) ? 0 : 1;
                tried += 2;
                climb.measureSpeedAbove(trial);
            }
        }
        trial.measure("wrong outcomes", wrong, "of " + tried, Limits.same(0));
    }

    /**
     * A disc and a step.
     *
     * @param away of its centre from the step as it starts, m
     */
    private record Climb(double radius, double height, double away) {

        double keptByImpact() {
            return 1 - 2 * height / (3 * radius);
        }

        double least() {
            return Math.sqrt(4 * Trial.GRAVITY * height / 3) / keptByImpact();
        }

        boolean isAbove(Trial trial, double ofLeast) {
            return after(trial, ofLeast * least()).x() > 0;
        }

        void measureSpeedAbove(Trial trial) {
            double speed = SURE * least();
            double impact = keptByImpact() * speed;
            double truth = Math.sqrt(impact * impact - 4 * Trial.GRAVITY * height / 3);
            double error = Math.abs(after(trial, speed).velocityX() - truth) / speed;
            trial.measure("speed above", error, "of v", Limits.of(0.02, 0.005));
        }

        /** The disc when it has turned back, rolls on above the step, or the time is up. */
        private RigidBody after(Trial trial, double speed) {
            WatchedPool pool = trial.ground(FRICTION, 0).withOverlapOfItsOwn();
            pool.add(Solid.fixed(100, 2, FRICTION, 0).at(50, height - 1));
            RigidBody disc =
                    pool.add(
                            Solid.disc(radius, FRICTION, 0)
                                    .at(-away, radius)
                                    .velocity(speed, 0)
                                    .spin(-speed / radius));
            double horizon = PATIENCE + away / speed;
            while (pool.time() < horizon && disc.x() > -away - radius && disc.x() < 1.5 * radius) {
                pool.step();
            }
            return disc;
        }
    }
}

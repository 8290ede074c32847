package rigibo.lab.problem;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Solid;

import java.util.Arrays;
import java.util.List;

/**
 * Masses on springs: x″ = −ω²·x has the solution x = cos(ωt + φ), v = −ω·sin(ωt + φ). The phase
 * advances by ωt, and v² + ω²x² stays ω². The phase is followed from step to step, so that a lag of
 * more than a turn is counted.
 */
final class Spring {

    /** The angular frequency of one period a second. */
    private static final double OMEGA = 2 * Math.PI;

    private static final double PERIODS = 100;

    /** φ, rad: no two differ by a quarter turn, where errors of energy would be alike. */
    private static final double[] PHASES = {0, 0.4, 0.8, 1.2};

    /** The error promised at EXACT, row origin/fields: a spring for a hundred turns. */
    private static final double EQUAL_BELOW = 1e-7;

    private Spring() {}

    static Problem problem() {
        return new Problem(
                "R3",
                "a mass on a spring for 100 periods",
                "phase after 100 periods, rad",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.STEP_EULER, Line.STEP_VERLET, Line.STEP_RK4, Line.SUBSTEPS),
                Spring::set);
    }

    private static Trial set(Bench bench) {
        double squared = OMEGA * OMEGA;
        World world = bench.world(Effects.of(new Field(at -> at.accelerate(-squared * at.x, 0))));
        for (double phase : PHASES) {
            world.add(Solid.disc(0.1).at(Math.cos(phase), 0).velocity(-OMEGA * Math.sin(phase), 0));
        }
        return () -> swing(bench, world);
    }

    private static Errors swing(Bench bench, World world) {
        double[] gone = new double[PHASES.length];
        double[] phase = PHASES.clone();
        double[] gain = new double[PHASES.length];
        int steps = bench.stepsIn(PERIODS * 2 * Math.PI / OMEGA);
        for (int step = 0; step < steps; step++) {
            bench.step(world);
            for (int i = 0; i < PHASES.length; i++) {
                double v = world.velocityX(i) / OMEGA;
                double now = Math.atan2(-v, world.x(i));
                gone[i] += Math.IEEEremainder(now - phase[i], 2 * Math.PI);
                phase[i] = now;
                double energy = v * v + world.x(i) * world.x(i);
                gain[i] = Math.max(gain[i], Math.abs(energy - 1));
            }
        }
        double truth = OMEGA * steps * bench.step();
        double[] late = Arrays.stream(gone).map(angle -> Math.abs(angle - truth)).toArray();
        return Errors.of(Mean.of(late)).with("largest change of energy, of E", Mean.of(gain));
    }
}

package rigibo.lab.problem;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;

import java.util.Arrays;
import java.util.List;

/**
 * Masses swing on springs, x″ = −ω²·x, which is solved by x = cos(ωt + φ), v = −ω·sin(ωt + φ): what
 * starts at the phase φ has gone on by ωt, and v² + ω²x² stays ω². The phase is followed from step
 * to step, so that an engine that lags by more than a turn is told from one that does not.
 */
final class Spring implements Problem {

    /** One period a second. */
    private static final double OMEGA = 2 * Math.PI;

    private static final double PERIODS = 100;

    /** φ, rad: none is a quarter turn from another, where errors of energy would be alike. */
    private static final double[] PHASES = {0, 0.4, 0.8, 1.2};

    @Override
    public String id() {
        return "R3";
    }

    @Override
    public String title() {
        return "a mass on a spring for 100 periods";
    }

    @Override
    public String error() {
        return "phase after 100 periods, rad";
    }

    /** The case origin/fields: a spring for a hundred turns. */
    @Override
    public double equalBelow() {
        return 1e-7;
    }

    @Override
    public List<Line> lines() {
        return List.of(Line.STEP, Line.STEP_EULER, Line.STEP_VERLET, Line.STEP_RK4, Line.SUBSTEPS);
    }

    @Override
    public Trial set(Bench bench) {
        double squared = OMEGA * OMEGA;
        World world = bench.world(Effects.of(new Field(at -> at.accelerate(-squared * at.x, 0))));
        for (double phase : PHASES) {
            world.add(
                    BodyDefinition.dynamic(new Circle(0.1))
                            .at(Math.cos(phase), 0)
                            .velocity(-OMEGA * Math.sin(phase), 0));
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

package rigibo.lab.engine;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Correction;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.ImpactSearch;
import rigibo.backend.setup.Integrator;

import java.util.List;
import java.util.Locale;
import java.util.function.BiConsumer;
import java.util.function.DoubleFunction;

/** The values of all knobs that the laboratory tries, from coarse to fine. */
final class Sweeps {

    private static final List<Integer> STEPS_PER_STEP = List.of(1, 2, 4, 8, 16, 32);

    /** The longest time step of a sweep, s: twice the game's. */
    private static final double LONGEST_STEP = 1.0 / 30;

    private static final double[] SUBSTEPS = {1, 2, 4, 8, 16, 32, 64};
    private static final double[] ITERATIONS = {1, 2, 3, 4, 6, 8};
    private static final double[] TOLERANCES = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
    private static final double[] IMPACTS_PER_PAIR = {4, 8, 16, 24, 32, 64};

    private final BiConsumer<Setting, Accuracy> take;

    Sweeps(BiConsumer<Setting, Accuracy> take) {
        this.take = take;
    }

    void all() {
        Accuracy game = Accuracy.GAME;
        take.accept(Setting.of("DRAFT", Line.PRESETS), Accuracy.DRAFT);
        take.accept(Setting.of("GAME", Line.PRESETS), game);
        take.accept(Setting.of("FINE", Line.PRESETS), Accuracy.FINE);
        take.accept(Setting.of("EXACT", Line.PRESETS), Accuracy.EXACT);
        steps(Line.STEP, game);
        steps(Line.STEP_EULER, game.withIntegrator(Integrator.EULER));
        steps(Line.STEP_VERLET, game.withIntegrator(Integrator.VERLET));
        steps(Line.STEP_RK4, game.withIntegrator(Integrator.RK4));
        steps(Line.STEP_DISCRETE, game.withImpacts(ImpactMode.DISCRETE));
        steps(Line.STEP_SPLIT, game.withImpacts(ImpactMode.SPLIT));
        sweep(Line.SUBSTEPS, SUBSTEPS, count -> game.withSubsteps((int) count));
        sweep(Line.ITERATIONS, ITERATIONS, count -> game.withVelocityIterations((int) count));
        sweep(Line.TOLERANCE, TOLERANCES, game::withImpactTolerance);
        sweep(
                Line.IMPACTS_PER_PAIR,
                IMPACTS_PER_PAIR,
                count -> game.withMaxImpactsPerPair((int) count));
        for (ImpactSearch search : ImpactSearch.values()) {
            take.accept(choice(Line.SEARCH, search), game.withSearch(search));
        }
        for (ContactSolver solver : ContactSolver.values()) {
            take.accept(choice(Line.SOLVER, solver), game.withContactSolver(solver));
        }
        for (Correction correction : Correction.values()) {
            take.accept(choice(Line.CORRECTION, correction), game.withCorrection(correction));
        }
    }

    private void steps(Line line, Accuracy accuracy) {
        for (int steps : STEPS_PER_STEP) {
            double step = LONGEST_STEP / steps;
            String name = line.words() + ", 1/" + 30 * steps + " s";
            take.accept(new Setting(name, line, step, step), accuracy);
        }
    }

    private void sweep(Line line, double[] values, DoubleFunction<Accuracy> turned) {
        for (double value : values) {
            String name =
                    line.words()
                            + " "
                            + (value < 1
                                    ? String.format(Locale.ROOT, "%.0e", value)
                                    : "" + (int) value);
            take.accept(new Setting(name, line, value, Setting.USUAL_STEP), turned.apply(value));
        }
    }

    private static Setting choice(Line line, Enum<?> value) {
        return Setting.of(line.words() + " " + value, line);
    }
}

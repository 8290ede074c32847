package rigibo.lab.problem;

import rigibo.backend.setup.Accuracy;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;

import java.util.ArrayList;
import java.util.List;

/**
 * The game's demos in their first moments. Their truth has no closed form; the reference is our own
 * EXACT at a sixteenth of the game's step. It stands for the truth as long as EXACT approaches it
 * with every halving of the step and chaos has not set in, that is, as long as a run that starts
 * 1e-9 m away stays within 1e-6 m. Tests hold both. The error is the root mean square of all
 * distances from the reference, thirty times a second, averaged over the four scenes.
 *
 * <p>Only our engine is measured by it: another engine may have soft contacts by design and another
 * law of impacts with friction, so that a distance from ours would not be an error.
 */
final class Demos {

    private static final double REFERENCE_STEP = Setting.USUAL_STEP / 16;

    /** The distance in m beyond which a body must have passed through another. */
    private static final double LOST = 1;

    private static final List<DemoScene> SCENES = DemoScenes.all();

    /** The reference, computed when first needed. */
    private static final class Reference {

        static final List<double[][]> PLACES = of();

        private static List<double[][]> of() {
            List<double[][]> places = new ArrayList<>();
            for (DemoScene scene : SCENES) {
                places.add(reference(scene));
            }
            return List.copyOf(places);
        }
    }

    /** The error promised at EXACT, row 11: the place of an impact. */
    private static final double EQUAL_BELOW = 1e-6;

    private Demos() {}

    static Problem problem() {
        return new Problem(
                        "R13",
                        "the four demos before chaos sets in",
                        "distance from EXACT at 1/960 s, m",
                        EQUAL_BELOW,
                        List.of(Line.STEP, Line.STEP_DISCRETE, Line.STEP_SPLIT, Line.TOLERANCE),
                        Demos::set)
                .ofOursAlone();
    }

    private static Trial set(Bench bench) {
        List<double[][]> truth = Reference.PLACES;
        List<World> worlds = new ArrayList<>();
        for (DemoScene scene : SCENES) {
            worlds.add(scene.build(bench.world(scene.effects())));
        }
        return () -> run(bench, worlds, truth);
    }

    private static Errors run(Bench bench, List<World> worlds, List<double[][]> truth) {
        double[] off = new double[worlds.size()];
        for (int i = 0; i < off.length; i++) {
            int steps = bench.stepsIn(DemoScene.LOOK);
            double[][] seen = SCENES.get(i).places(worlds.get(i), steps, bench::step);
            if (!(farthest(seen, truth.get(i)) < LOST)) {
                return Errors.failed(SCENES.get(i).name() + ": a body is not where it could be");
            }
            off[i] = distance(seen, truth.get(i));
        }
        Errors errors = Errors.of(Mean.of(off));
        for (int i = 0; i < off.length; i++) {
            errors = errors.with(SCENES.get(i).name() + ", m", off[i]);
        }
        return errors;
    }

    /** The places of a scene's bodies at EXACT and a sixteenth of the game's step. */
    static double[][] reference(DemoScene scene) {
        try (World world = RigiBoEngine.world(scene.effects(), Accuracy.EXACT)) {
            int steps = (int) Math.round(DemoScene.LOOK / REFERENCE_STEP);
            return scene.places(scene.build(world), steps, at -> at.step(REFERENCE_STEP));
        }
    }

    /** Root mean square over samples and bodies, m. */
    static double distance(double[][] some, double[][] others) {
        double squares = 0;
        for (int look = 0; look < some.length; look++) {
            for (int i = 0; i < some[look].length; i++) {
                double away = some[look][i] - others[look][i];
                squares += away * away;
            }
        }
        return Math.sqrt(squares / (some.length * some[0].length / 2.0));
    }

    /** The largest distance along x or y, m; NaN if one of them is NaN. */
    static double farthest(double[][] some, double[][] others) {
        double most = 0;
        for (int look = 0; look < some.length; look++) {
            for (int i = 0; i < some[look].length; i++) {
                most = Math.max(most, Math.abs(some[look][i] - others[look][i]));
            }
        }
        return most;
    }
}

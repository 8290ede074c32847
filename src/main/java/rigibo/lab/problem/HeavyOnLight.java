package rigibo.lab.problem;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * A box of 1 m carries another of up to 10⁴ times its mass. Both are rigid and stand, so after 2 s
 * neither overlaps the other or the floor; L = 1 mm is tolerated. The phases are the ratios of
 * mass. The run fails if the light box is pushed out or passed through.
 */
final class HeavyOnLight {

    private static final double SECONDS = 2;
    private static final double TOLERATED = 1e-3;

    /** The gaps at the start, m: some engines give polygons a skin of 1 cm. */
    private static final double GAP = 0.02;

    private static final double[] RATIOS = {1, 10, 100, 1000, 10_000};

    private static final int LIGHT = 1;
    private static final int HEAVY = 2;

    /** The error promised at EXACT, row 55. */
    private static final double EQUAL_BELOW = 2;

    private HeavyOnLight() {}

    static Problem problem() {
        return new Problem(
                "R12",
                "a box under another of up to 10,000 times its mass",
                "overlap / L, L = 1 mm",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.SUBSTEPS, Line.SOLVER),
                HeavyOnLight::set);
    }

    private static Trial set(Bench bench) {
        World[] worlds = new World[RATIOS.length];
        for (int i = 0; i < worlds.length; i++) {
            worlds[i] = bench.world(Earth.effects());
            worlds[i].add(Earth.floor(0.6, 0));
            worlds[i].add(box(1).at(0, 0.5 + GAP));
            worlds[i].add(box(RATIOS[i]).at(0, 1.5 + 2 * GAP));
        }
        return () -> stand(bench, worlds);
    }

    private static BodyDefinition box(double density) {
        return Solid.box(1, 1).material(new Material(density, 0.6, 0));
    }

    private static Errors stand(Bench bench, World[] worlds) {
        double[] overlap = new double[worlds.length];
        for (int i = 0; i < worlds.length; i++) {
            for (int step = 0; step < bench.stepsIn(SECONDS); step++) {
                bench.step(worlds[i]);
            }
            double light = worlds[i].y(LIGHT);
            double heavy = worlds[i].y(HEAVY);
            if (!(Math.abs(worlds[i].x(LIGHT)) < 0.5 && light > 0 && heavy > 1)) {
                return Errors.failed("the light box of 1:" + (int) RATIOS[i] + " did not stand");
            }
            double deepest = Math.max(0.5 - light, light + 1 - heavy);
            overlap[i] = Math.max(0, deepest) / TOLERATED;
        }
        Errors errors = Errors.of(Mean.of(overlap));
        for (int i = 0; i < worlds.length; i++) {
            errors = errors.with("1:" + (int) RATIOS[i] + ", overlap / L", overlap[i]);
        }
        return errors;
    }
}

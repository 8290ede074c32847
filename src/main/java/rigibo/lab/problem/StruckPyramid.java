package rigibo.lab.problem;

import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.Line;

import java.util.ArrayList;
import java.util.List;

/**
 * A pyramid is struck at its foot each second. Its boxes are rigid: none ever overlap, and all
 * energy is that of the start and of the strikes. The phases are strikes that differ a little.
 */
final class StruckPyramid implements Problem {

    private static final double SECONDS = 10;

    /** The first box of the base, after the floor. */
    private static final int FOOT = 1;

    /** What a strike makes a box go that nothing is in the way of, m/s. */
    private static final double[] SPEEDS = {9.7, 10, 10.3};

    private final int storeys;

    StruckPyramid(int storeys) {
        this.storeys = storeys;
    }

    @Override
    public String id() {
        return "R16";
    }

    @Override
    public String title() {
        return "a pyramid of " + storeys + " storeys, struck at its foot";
    }

    @Override
    public String error() {
        return "deepest overlap / width";
    }

    /** Row M1, above 400 bodies. */
    @Override
    public double equalBelow() {
        return 0.10;
    }

    @Override
    public List<Line> lines() {
        return List.of(Line.STEP, Line.SUBSTEPS, Line.SOLVER);
    }

    @Override
    public Trial set(Bench bench) {
        Scene scene = Commotions.struck(storeys);
        int top = scene.bodies().size() - 1;
        double height = scene.bodies().get(top).y();
        List<CrowdWatch> pyramids = new ArrayList<>();
        for (int i = 0; i < SPEEDS.length; i++) {
            pyramids.add(new CrowdWatch(bench, scene));
        }
        return () -> {
            for (int i = 0; i < SPEEDS.length; i++) {
                double mass = scene.bodies().get(FOOT).massProperties().mass();
                strike(bench, pyramids.get(i), SPEEDS[i] * mass);
            }
            double sunk = Crowds.median(pyramids, pyramid -> height - pyramid.world().y(top));
            return Crowds.errors(pyramids).with("sinking of the top, m", sunk);
        };
    }

    private static void strike(Bench bench, CrowdWatch pyramid, double impulse) {
        int every = bench.stepsIn(1);
        for (int i = 0; i < bench.stepsIn(SECONDS); i++) {
            if (i > 0 && i % every == 0) {
                pyramid.strike(FOOT, impulse);
            }
            pyramid.step();
        }
    }
}

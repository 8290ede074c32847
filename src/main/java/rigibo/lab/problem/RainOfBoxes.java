package rigibo.lab.problem;

import rigibo.lab.bench.scene.Crowd;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.Line;

import java.util.ArrayList;
import java.util.List;

/**
 * Boxes rain into a trough. Where they lie in the end nobody can say, but they are rigid: no two
 * ever overlap, and all energy is that of the fall. The phases are rains of other seeds.
 */
final class RainOfBoxes implements Problem {

    private static final double SECONDS = 7;
    private static final long[] SEEDS = {14, 15, 16};

    private final int boxes;

    RainOfBoxes(int boxes) {
        this.boxes = boxes;
    }

    @Override
    public String id() {
        return "R14";
    }

    @Override
    public String title() {
        return boxes + " boxes that rain into a trough";
    }

    @Override
    public String error() {
        return "deepest overlap / width";
    }

    /** Row M1, up to 400 bodies. */
    @Override
    public double equalBelow() {
        return 0.05;
    }

    @Override
    public List<Line> lines() {
        return List.of(Line.STEP, Line.SUBSTEPS, Line.ITERATIONS, Line.SOLVER);
    }

    @Override
    public Trial set(Bench bench) {
        List<CrowdWatch> rains = new ArrayList<>();
        for (long seed : SEEDS) {
            rains.add(
                    new CrowdWatch(bench, new Scene(Crowd.EFFECTS, Crowd.BOXES.rain(boxes, seed))));
        }
        return () -> {
            rains.forEach(rain -> fall(bench, rain));
            return Crowds.errors(rains);
        };
    }

    private static void fall(Bench bench, CrowdWatch rain) {
        for (int i = 0; i < bench.stepsIn(SECONDS); i++) {
            rain.step();
        }
    }
}

package rigibo.lab.problem;

import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.engine.Line;

import java.util.ArrayList;
import java.util.List;

/**
 * A pyramid falls together from equal vertical gaps. Its boxes are rigid: none ever overlap, all
 * energy is that of the fall, and then it stands. The phases are gaps that differ a little.
 */
final class SettlingPyramid implements Problem {

    private static final double SECONDS = 10;
    private static final double[] GAPS = {0.0195, 0.02, 0.0205};

    private final int storeys;

    SettlingPyramid(int storeys) {
        this.storeys = storeys;
    }

    @Override
    public String id() {
        return "R15";
    }

    @Override
    public String title() {
        return "a pyramid of " + storeys + " storeys that falls together";
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
        List<CrowdWatch> pyramids = new ArrayList<>();
        for (double gap : GAPS) {
            pyramids.add(new CrowdWatch(bench, Commotions.settling(storeys, gap)));
        }
        return () -> {
            pyramids.forEach(pyramid -> fall(bench, pyramid));
            double fastest = Crowds.median(pyramids, CrowdWatch::fastest);
            return Crowds.errors(pyramids).with("speed left, m/s", fastest);
        };
    }

    private static void fall(Bench bench, CrowdWatch pyramid) {
        for (int i = 0; i < bench.stepsIn(SECONDS); i++) {
            pyramid.step();
        }
    }
}

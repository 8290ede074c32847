package rigibo.lab.hardcase;

import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.bench.scene.Scene;

import java.util.List;

/**
 * A pyramid built with equal vertical gaps settles, e = 0. Truth: no box falls farther than the sum
 * of the gaps below it, so none is faster than √(2g·Σgaps), and none is thrown up. No energy is
 * gained. 10 s later the pyramid stands.
 */
record SettlingPyramid(List<Variant> few, List<Variant> all) implements Scenes {

    private static final double HORIZON = 10;
    private static final double MOST_SPEED_AT_REST = 1e-3;

    /** Allowance for substeps and for the speed of bodies that are pushed out of overlap. */
    private static final double SLACK = 1.01;

    /** A pyramid, and the gaps in it, m. */
    record Variant(int base, double gap) {}

    /** Up to 20 storeys. */
    static final SettlingPyramid LOW =
            new SettlingPyramid(
                    List.of(new Variant(10, 0.001), new Variant(13, 0.05), new Variant(17, 0.02)),
                    List.of(
                            new Variant(10, 0.001),
                            new Variant(10, 0.05),
                            new Variant(12, 0.007),
                            new Variant(13, 0.05),
                            new Variant(15, 0.03),
                            new Variant(17, 0.02),
                            new Variant(20, 0.002),
                            new Variant(20, 0.02)));

    /** Up to 100 storeys. */
    static final SettlingPyramid HIGH =
            new SettlingPyramid(
                    List.of(new Variant(33, 0.02)),
                    List.of(
                            new Variant(33, 0.02),
                            new Variant(40, 0.001),
                            new Variant(50, 0.02),
                            new Variant(50, 0.05),
                            new Variant(71, 0.005),
                            new Variant(100, 0.001),
                            new Variant(100, 0.02)));

    @Override
    public void run(Trial trial) {
        for (Variant variant : trial.sampling().of(few, all)) {
            trial.variant(variant.base + " storeys, gaps of " + variant.gap + " m");
            fall(trial, variant);
        }
    }

    private static void fall(Trial trial, Variant variant) {
        StagedScene stage =
                new StagedScene(trial, dead(Commotions.settling(variant.base, variant.gap)));
        WatchedPool pool = stage.pool();
        double gaps = variant.base * variant.gap;
        double most = Math.sqrt(2 * Trial.GRAVITY * gaps);
        double fastest = 0;
        while (pool.time() < HORIZON) {
            stage.step();
            fastest = Math.max(fastest, pool.fastest());
        }
        trial.measure("fastest", fastest / most, "of a fall", SLACK);
        Limits rest = Limits.same(MOST_SPEED_AT_REST);
        trial.measure("fastest after 10 s", pool.fastest(), "m/s", rest);
        trial.measure("deepest overlap", pool.deepestShare(), "width", Limits.NONE);
    }

    private static Scene dead(Scene scene) {
        List<BodyDefinition> bodies =
                scene.bodies().stream()
                        .map(body -> body.material(body.material().elasticity(0)))
                        .toList();
        return new Scene(scene.effects(), bodies);
    }
}

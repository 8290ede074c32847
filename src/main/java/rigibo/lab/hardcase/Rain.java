package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.bench.scene.Crowd;
import rigibo.lab.bench.scene.Scene;

import java.util.List;

/**
 * Boxes, discs or both fall at any angle into a trough. Truth: nothing passes through anything, and
 * all energy comes from the fall. Friction and the rolling resistance of discs, 0.01 r, dissipate
 * it, so every heap comes to rest. The last body lands no later than by a free fall from its start
 * to the floor, √(2y/g); 10 s after that nothing is faster than 1 mm/s, and with Sleep all sleep.
 *
 * @param crowd what falls
 * @param overlap its limit in widths of the smaller body, from GAME on
 * @param few sizes that are tried as a rule
 * @param all sizes
 */
record Rain(Crowd crowd, double overlap, List<Integer> few, List<Integer> all) implements Scenes {

    private static final double PATIENCE = 10;
    private static final double MOST_SPEED = 1e-3;
    private static final Limits MOST_OVERLAP_AT_REST = new Limits(0.02, 0.005, 0.005);
    private static final double ROLLING_LEVER_BY_RADIUS = 0.01;

    @Override
    public void run(Trial trial) {
        for (int size : trial.sampling().of(few, all)) {
            long seed = trial.sampling().random(size).nextLong();
            trial.variant(size + " bodies, seed " + seed);
            Scene scene = scene(size, seed);
            double rest = lastLanding(scene) + PATIENCE;
            fall(trial, scene, rest);
            StagedScene sleeping = new StagedScene(trial, scene, scene.effects().with(new Sleep()));
            sleeping.runUntil(rest);
            long awake = sleeping.dynamic().stream().filter(RigidBody::isAwake).count();
            trial.measure("awake 10 s after landing", awake, "bodies", 0);
        }
    }

    private Scene scene(int size, long seed) {
        Effects effects = Crowd.EFFECTS.with(new RollingResistance());
        return new Scene(effects, crowd.rain(size, seed).stream().map(Rain::withRolling).toList());
    }

    private static BodyDefinition withRolling(BodyDefinition body) {
        return body.shape() instanceof Circle
                ? body.material(
                        body.material()
                                .rollingResistance(
                                        ROLLING_LEVER_BY_RADIUS * ((Circle) body.shape()).radius()))
                : body;
    }

    private static double lastLanding(Scene scene) {
        double highest = scene.bodies().stream().mapToDouble(BodyDefinition::y).max().orElse(0);
        return Math.sqrt(2 * highest / Trial.GRAVITY);
    }

    private void fall(Trial trial, Scene scene, double rest) {
        StagedScene stage = new StagedScene(trial, scene);
        WatchedPool pool = stage.pool();
        Passages passages = new Passages(stage.bodies());
        int passed = 0;
        while (pool.time() < rest) {
            stage.step();
            passed += passages.count();
        }
        trial.measure("passed through each other", passed, "pairs", 0);
        long lost = stage.dynamic().stream().filter(body -> body.y() < 0).count();
        trial.measure("fell through the floor", lost, "bodies", 0);
        Limits limits = new Limits(0.5, overlap, overlap);
        trial.measure("overlap while it rains", pool.deepestShare(), "width", limits);
        trial.measure("overlap at rest", pool.overlapNow(), "width", MOST_OVERLAP_AT_REST);
        trial.measure("fastest at rest", pool.fastest(), "m/s", MOST_SPEED);
    }
}

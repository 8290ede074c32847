package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * Fifteen dominoes of 0.25 × 1 at a spacing of 1, the first struck at its top by 0.2 N·s. Truth:
 * all fall and end at rest. A single one that turns about its lower edge falls if its energy I·ω²/2
 * with I = m(w² + h²)/3 lifts its centre over the edge, by (√(w² + h²) − h)/2: from ω0 = 0.9233
 * rad/s.
 */
final class Dominoes implements HardCase {

    private static final int COUNT = 15;
    private static final double WIDTH = 0.25;
    private static final double IMPULSE = 0.2;
    private static final double HORIZON = 20;

    @Override
    public String row() {
        return "60/dominoes";
    }

    @Override
    public String title() {
        return "a row of dominoes falls, and one falls only if struck enough";
    }

    /** One substep a step is too few for what turns on a corner. */
    @Override
    public Preset limitedFrom() {
        return Preset.GAME;
    }

    @Override
    public String finding() {
        return "At FINE and EXACT a domino struck at 1.01 of the threshold has some millionths more"
                + " energy, when it falls, than it began with.";
    }

    @Override
    public void run(Trial trial) {
        trial.variant("row");
        row(trial);
        double diagonal = Math.hypot(WIDTH, 1);
        double lift = (diagonal - 1) / 2;
        double threshold = Math.sqrt(2 * Trial.GRAVITY * lift / (diagonal * diagonal / 3));
        for (double share : new double[] {0.99, 1.01}) {
            trial.variant(share + " of the threshold");
            boolean falls = falls(trial, share * threshold);
            trial.require("falls above the threshold only", falls == share > 1);
        }
    }

    private static void row(Trial trial) {
        WatchedPool pool = trial.pool(Surroundings.earth());
        pool.add(Surroundings.floor(0.5, 0));
        List<RigidBody> dominoes = new ArrayList<>();
        for (int i = 0; i < COUNT; i++) {
            dominoes.add(pool.add(BodyDefinition.dynamic(Polygon.box(WIDTH, 1)).at(i, 0.5)));
        }
        dominoes.get(0).applyImpulse(IMPULSE, 0, 0, 1);
        pool.changed();
        pool.run(HORIZON);
        double fastest = 0;
        for (RigidBody domino : dominoes) {
            trial.require("every domino falls", domino.angle() < -Math.PI / 4);
            fastest = Math.max(fastest, Math.hypot(domino.velocityX(), domino.velocityY()));
        }
        trial.measure("fastest in the end", fastest, "m/s", 1e-3);
    }

    /** Turns about its lower right edge, which is at rest: v = ω × r. */
    private static boolean falls(Trial trial, double spin) {
        WatchedPool pool = trial.pool(Surroundings.earth());
        pool.add(Surroundings.floor(0.9, 0));
        RigidBody domino =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(WIDTH, 1))
                                .at(0, 0.5)
                                .velocity(spin / 2, spin * WIDTH / 2)
                                .spin(-spin)
                                .material(Surroundings.matter(0.9, 0)));
        pool.run(4);
        return domino.angle() < -Math.PI / 4;
    }
}

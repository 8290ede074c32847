package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * Five storeys of cards of 0.4 × 0.002 m, μ = 0.7: pairs that lean against each other at 25° to the
 * vertical, and cards laid across from ridge to ridge, each with its left end on the one before it.
 * Truth: a pair of weight 2W under a load of 2P needs at its feet the horizontal force (P +
 * W/2)·tan 25° per (P + W) of weight, at most 0.47 of it. Friction holds that, so the house stands.
 * It is laid with gaps of a fraction of a millimetre, and its outer feet are one thickness of a
 * card too high; over five storeys this adds up to a centimetre at most.
 */
final class CardHouse implements Scenes {

    private static final int STOREYS = 5;
    private static final double LENGTH = 0.4;
    private static final double THICKNESS = 0.002;
    private static final double LEAN = Math.toRadians(25);
    private static final double SPACING = 0.35;
    private static final double GAP = 1e-4;
    private static final double FRICTION = 0.7;
    private static final double HORIZON = 10;

    /** Height from the feet of a pair to its ridge. */
    private static final double RISE = LENGTH * Math.cos(LEAN) + THICKNESS * Math.sin(LEAN);

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.ground(FRICTION, 0);
        Places starts = new Places(build(pool));
        pool.run(HORIZON);
        trial.measure("moved in 10 s", starts.farthest(), "m", 0.02);
        trial.measure("fastest in the end", pool.fastest(), "m/s", 1e-3);
    }

    private static List<RigidBody> build(WatchedPool pool) {
        List<RigidBody> cards = new ArrayList<>();
        double foot = 0;
        for (int storey = 0; storey < STOREYS; storey++) {
            int pairs = STOREYS - storey;
            double left = -SPACING * (pairs - 1) / 2;
            double ridge = foot + RISE + GAP;
            for (int i = 0; i < pairs; i++) {
                pair(pool, cards, left + i * SPACING, foot);
            }
            for (int i = 0; i + 1 < pairs; i++) {
                across(pool, cards, left + i * SPACING, ridge, i > 0);
            }
            foot = ridge + 2 * THICKNESS + 4 * GAP;
        }
        return cards;
    }

    private static void pair(WatchedPool pool, List<RigidBody> cards, double x, double foot) {
        double aside = (LENGTH * Math.sin(LEAN) + THICKNESS * Math.cos(LEAN)) / 2 + GAP / 2;
        double y = foot + GAP + RISE / 2;
        cards.add(pool.add(card().at(x - aside, y).angle(Math.PI / 2 - LEAN)));
        cards.add(pool.add(card().at(x + aside, y).angle(Math.PI / 2 + LEAN)));
    }

    /** The first lies on two ridges, the others with their left end on the one before. */
    private static void across(
            WatchedPool pool, List<RigidBody> cards, double x, double ridge, boolean isUpon) {
        double low = ridge + GAP + THICKNESS / 2;
        double high = isUpon ? low + THICKNESS + 2 * GAP : low;
        double angle = Math.atan((low - high) / SPACING);
        cards.add(pool.add(card().at(x + SPACING / 2, (low + high) / 2).angle(angle)));
    }

    private static BodyDefinition card() {
        return Solid.box(LENGTH, THICKNESS, FRICTION, 0);
    }
}

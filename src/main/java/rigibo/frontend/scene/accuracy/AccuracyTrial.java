package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.trial.Trial;

import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;

/**
 * Half a second of a scene, simulated from the same state three times without input: at the present
 * accuracy, at DRAFT and at EXACT. The three are stepped in turn, so that other work of the machine
 * affects all of them alike.
 */
final class AccuracyTrial implements Trial<AccuracyTrial.Result> {

    /** Half a second: longer, and of a chaotic scene only the chaos would be told. */
    static final int STEPS = 30;

    /** The first steps of a restored pool also lay out its scratch: they are not timed. */
    private static final int WARMING_STEPS = 2;

    /** No round is begun any more once a trial has taken so long, ns, and its price is known. */
    private static final long LONGEST = 500_000_000;

    private static final int FEWEST_STEPS = WARMING_STEPS + 2;

    private static final int PRESENT = 0;
    private static final int DRAFT = 1;
    private static final int EXACT = 2;

    private final byte[] snapshot;
    private final Effects effects;
    private final Accuracy[] accuracies;
    private final LongSupplier clock;
    private final long mostPiece;
    private final Pool[] copies = new Pool[EXACT + 1];

    /** Time of the first steps of each copy, and of those after them, ns. */
    private final long[] warmingNanos = new long[copies.length];

    private final long[] stepNanos = new long[copies.length];

    private int pieces;
    private long nanos;
    private long longest;

    /**
     * A trial that has not begun.
     *
     * @param snapshot of the pool
     * @param effects simulated there; given beside the snapshot because functions are not in it
     * @param accuracy the present one
     * @param clock ns
     * @param mostPiece the trial ends with the round in which a piece takes longer, ns
     */
    AccuracyTrial(
            byte[] snapshot,
            Effects effects,
            Accuracy accuracy,
            LongSupplier clock,
            long mostPiece) {
        this.snapshot = snapshot;
        this.effects = effects;
        this.clock = clock;
        this.mostPiece = mostPiece;
        accuracies = new Accuracy[] {accuracy, Accuracy.DRAFT, Accuracy.EXACT};
    }

    /**
     * The result of a trial.
     *
     * @param price time of a step as a multiple of that at DRAFT; NaN where no time was measured
     * @param error root mean square, over the dynamic bodies, of the distance to their places at
     *     EXACT, m
     * @param steps that were made
     * @param nanos time of the whole trial, ns
     * @param longest time of its longest piece, ns
     */
    record Result(double price, double error, int steps, long nanos, long longest) {

        /** Whether it went the whole way, or was cut short because the scene is slow. */
        boolean isWhole() {
            return steps == STEPS;
        }
    }

    /** Makes a copy, or a step of one; copies take turns. */
    @Override
    public Optional<Result> goOn() {
        long begin = clock.getAsLong();
        int turn = pieces % copies.length;
        if (pieces < copies.length) {
            copies[turn] = Pool.restore(snapshot, effects);
            copies[turn].accuracy(accuracies[turn]);
        } else {
            copies[turn].step(Scene.STEP);
            long[] kind = steps() < WARMING_STEPS ? warmingNanos : stepNanos;
            kind[turn] += clock.getAsLong() - begin;
        }
        pieces++;
        long took = clock.getAsLong() - begin;
        nanos += took;
        longest = Math.max(longest, took);
        return isOver() ? Optional.of(result()) : Optional.empty();
    }

    /** That every copy has made. */
    private int steps() {
        return pieces / copies.length - 1;
    }

    private boolean isOver() {
        boolean isRound = pieces % copies.length == 0 && steps() > 0;
        boolean isEnough = steps() >= FEWEST_STEPS && (steps() == STEPS || nanos >= LONGEST);
        return isRound && (isEnough || longest > mostPiece);
    }

    private Result result() {
        long[] timed = steps() > WARMING_STEPS ? stepNanos : warmingNanos;
        double price = (double) timed[PRESENT] / timed[DRAFT];
        return new Result(price, error(), steps(), nanos, longest);
    }

    private double error() {
        List<RigidBody> here = copies[PRESENT].bodies();
        List<RigidBody> there = copies[EXACT].bodies();
        double squares = 0;
        int count = 0;
        for (int i = 0; i < here.size(); i++) {
            if (here.get(i).type() == BodyType.DYNAMIC) {
                double dx = here.get(i).x() - there.get(i).x();
                double dy = here.get(i).y() - there.get(i).y();
                squares += dx * dx + dy * dy;
                count++;
            }
        }
        return Math.sqrt(squares / Math.max(1, count));
    }
}

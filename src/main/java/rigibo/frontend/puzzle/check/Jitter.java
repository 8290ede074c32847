package rigibo.frontend.puzzle.check;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Varies a level: bodies slightly displaced, clicks slightly late; the same seed gives the same
 * variation. Seed 0 is the level as the file states it.
 */
final class Jitter {

    /** Seed of the level as the file states it. */
    static final int STATED = 0;

    /** Largest displacement of a body, m. */
    private static final double MOST = 0.010;

    /**
     * Separates the random numbers of clicks from those of bodies, whose count depends on the
     * level.
     */
    private static final long CLICKS = 1L << 32;

    private Jitter() {}

    static Level of(Level level, int seed) {
        if (seed == STATED) {
            return level;
        }
        SplittableRandom random = new SplittableRandom(seed);
        return level.shiftedSideways(() -> random.nextDouble(-MOST, MOST));
    }

    /**
     * Varies a stored solution, for a level varied by the same seed.
     *
     * @param latest largest delay of a click relative to the one before it, steps
     */
    static Replay of(Level moved, Solution solution, Accuracy accuracy, int seed, int latest) {
        Replay stated = Replay.of(moved, solution, accuracy);
        if (seed == STATED) {
            return stated;
        }
        SplittableRandom random = new SplittableRandom(CLICKS + seed);
        List<Act> late = new ArrayList<>();
        int lateness = 0;
        for (Act click : stated.acts()) {
            lateness += random.nextInt(latest + 1);
            late.add(new Act(click.step() + lateness, click.target()));
        }
        return new Replay(stated.levelHash(), late, accuracy);
    }
}

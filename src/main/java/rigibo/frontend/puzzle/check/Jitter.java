package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Level;

import java.util.SplittableRandom;

/** Levels whose bodies stand a little aside; the same seed gives the same level. */
final class Jitter {

    /** How far a body may be moved, m. */
    static final double MOST = 0.010;

    private Jitter() {}

    static Level of(Level level, int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return level.shiftedSideways(() -> random.nextDouble(-MOST, MOST));
    }
}

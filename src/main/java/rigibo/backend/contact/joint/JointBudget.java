package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;

/**
 * The work that an island with joints is worth: whether all of its rows are eliminated, and how
 * much work that may take; how many impacts are resolved at their time; and how many passes replace
 * a failed elimination.
 */
final class JointBudget {

    /**
     * Multiplications of one elimination up to which an island is eliminated; and those from EXACT
     * on.
     */
    private static final double WORTH = 1e6;

    private static final double WORTH_IF_EXACT = 1e8;

    /**
     * Largest and least budget of an island in a substep, in eliminations of all of its rows.
     * Newton's steps take some ten eliminations; an island that takes fifty tries sets of rows that
     * contradict each other. What is left to do in the step is then left to passes.
     */
    private static final double ELIMINATIONS = 64;

    private static final double FEWEST_ELIMINATIONS = 4;

    /**
     * Largest budget of an island in a step of GAME, in multiplications, unless the least one is
     * larger; it grows with the square of the number of substeps. From EXACT on it is the second
     * number.
     */
    private static final double MOST_WORTH = 4e6;

    private static final double MOST_WORTH_IF_EXACT = 3.2e9;

    /**
     * Least budget of a small island in a step of GAME, in multiplications. It grows with the
     * square of the number of substeps.
     */
    private static final double LEAST_WORTH = 1e6;

    /**
     * Most row solutions of passes in a step, and the number of passes in a substep that are made
     * in any case.
     */
    private static final int SOLVES = 1_000_000;

    private static final int LEAST_PASSES = 8;

    /** Most passes in a substep, for each substep of the accuracy. */
    private static final int PASSES_PER_SUBSTEP = 20;

    /** Most rows of an island that is eliminated although its contacts may open and close. */
    private static final int MOST_ROWS = 400;

    /**
     * Most rows with bounds of such an island; and those from EXACT on. Where more of them enter
     * and leave the set, passes take less time, but may add energy.
     */
    private static final int MOST_BOUNDED = 60;

    private static final int MOST_BOUNDED_IF_EXACT = 200;

    /** Usual least number of rows of a contact or a joint. */
    private static final int LEAST_ROWS = 2;

    /**
     * Most rows of a small island. Its impacts are resolved at their time, and the work of its
     * equations in a kick does not count as an error. In larger islands, rows that contradict each
     * other are common.
     */
    private static final int FEW_ROWS = 150;

    /** Rows times impacts that an island is worth in a substep. */
    private static final int STRUCK_ROWS = 1000;

    private final Islands islands;
    private final JointStore joints;
    private final NeutralRows rows;
    private final RowElimination elimination;
    private final int substeps;
    private final double worth;
    private final double leastWorth;
    private final double mostWorth;
    private final int mostBounded;

    private boolean isSmall;
    private boolean isWhole;
    private int mostStrikes;
    private int mostPasses;

    JointBudget(DataStorage data, NeutralRows rows, RowElimination elimination, Accuracy accuracy) {
        islands = data.islands;
        joints = data.jointsOrNone();
        this.rows = rows;
        this.elimination = elimination;
        substeps = accuracy.substeps();
        double times = Math.max(1, Effort.timesGame(accuracy));
        leastWorth = LEAST_WORTH * times * times;
        boolean isExact = Effort.isExact(accuracy);
        worth = isExact ? WORTH_IF_EXACT : WORTH;
        mostWorth = isExact ? MOST_WORTH_IF_EXACT : MOST_WORTH * times * times;
        mostBounded = isExact ? MOST_BOUNDED_IF_EXACT : MOST_BOUNDED;
    }

    /** Whether an island is too large for its contacts and limits to be eliminated. */
    boolean areMany(int island) {
        int contactCount = contacts(island);
        int jointCount = islands.jointStart[island + 1] - islands.jointStart[island];
        return contactCount > 0 && LEAST_ROWS * (contactCount + jointCount) > MOST_ROWS;
    }

    /**
     * Whether so many contacts and limits of an island may open and close that passes do better.
     */
    boolean areManyBounded(int island) {
        int contactCount = contacts(island);
        int bounded = LEAST_ROWS * contactCount;
        for (int i = islands.jointStart[island]; i < islands.jointStart[island + 1]; i++) {
            int slot = islands.joints[i];
            boolean isLimited =
                    joints.lower[slot] > Double.NEGATIVE_INFINITY
                            || joints.upper[slot] < Double.POSITIVE_INFINITY;
            bounded += (isLimited ? 1 : 0) + (joints.motorMost[slot] > 0 ? 1 : 0);
        }
        return contactCount > 0 && bounded > mostBounded;
    }

    private int contacts(int island) {
        return islands.pairStart[island + 1] - islands.pairStart[island];
    }

    /** Begins an island whose rows are written, for a number of substeps. */
    void begin(boolean areMany, int substepsOfIsland) {
        isSmall = rows.count <= FEW_ROWS;
        mostStrikes = isSmall ? STRUCK_ROWS / Math.max(1, rows.count) : 0;
        double one = isTiny(substepsOfIsland) ? 0 : elimination.workOfAll();
        isWhole = !areMany && one <= worth;
        double onePerSubstep = one * substepsOfIsland;
        double least = Math.max(isSmall ? leastWorth : 0, FEWEST_ELIMINATIONS * onePerSubstep);
        double most = Math.min(mostWorth, ELIMINATIONS * onePerSubstep);
        elimination.beginIsland(Math.max(least, most));
        int affordable = SOLVES / (substepsOfIsland * Math.max(1, rows.count));
        mostPasses = Math.max(LEAST_PASSES, Math.min(PASSES_PER_SUBSTEP * substeps, affordable));
    }

    /**
     * Whether the budget exceeds the work of all eliminations in any order of the rows, so that the
     * order need not be found.
     */
    private boolean isTiny(int substepsOfIsland) {
        double n = rows.count;
        double most = n * (n + 1) * (2 * n + 1) / 12;
        return isSmall && ELIMINATIONS * most * substepsOfIsland <= leastWorth;
    }

    /** Stops using elimination once it has spent the island's budget. */
    void review() {
        isWhole &= !elimination.isSpent();
    }

    /** Whether the island is small enough to be eliminated, and was as of the last review. */
    boolean isWhole() {
        return isWhole;
    }

    /**
     * Whether the island is small: its impacts are resolved at their time, and its equations may do
     * work in a kick.
     */
    boolean isSmall() {
        return isSmall;
    }

    /** Most impacts in a substep that are resolved at their time. */
    int mostStrikes() {
        return mostStrikes;
    }

    /** Most passes over the island's rows in a substep. */
    int mostPasses() {
        return mostPasses;
    }
}

package rigibo.backend.storage;

import rigibo.backend.setup.SolveMethod;

import java.util.Arrays;

/** Work of one island solver in the step in progress. */
public final class IslandWork {

    public int impacts;
    public int crushed;

    /** Number of times that a contact was solved in a pass, and multiplications in eliminations. */
    public long contactSolves;

    public double multiplications;

    /** Islands, and their rows, by the method that solved them. */
    final int[] islandsBy = new int[SolveMethod.values().length];

    final int[] rowsBy = new int[SolveMethod.values().length];

    /** Notes an island, with its number of rows, and the method that solved it. */
    public void solve(SolveMethod method, int rowCount) {
        rowsBy[method.ordinal()] += rowCount;
        islandsBy[method.ordinal()]++;
    }

    /** Clears all counters. */
    void clear() {
        impacts = 0;
        crushed = 0;
        contactSolves = 0;
        multiplications = 0;
        Arrays.fill(islandsBy, 0);
        Arrays.fill(rowsBy, 0);
    }
}

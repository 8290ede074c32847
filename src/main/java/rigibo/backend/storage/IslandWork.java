package rigibo.backend.storage;

import rigibo.backend.setup.SolveMethod;

import java.util.Arrays;

/** What one solver of islands did in the step in progress, and what that cost. */
public final class IslandWork {

    public int impacts;
    public int crushed;

    /** How often a contact was solved in a pass, and what eliminations multiplied. */
    public long contactSolves;

    public double multiplications;

    /** Islands, and their rows, by the method that solved them. */
    final int[] islandsBy = new int[SolveMethod.values().length];

    final int[] rowsBy = new int[SolveMethod.values().length];

    /** Notes an island of so many rows that was solved by a method. */
    public void solve(SolveMethod method, int rowCount) {
        rowsBy[method.ordinal()] += rowCount;
        islandsBy[method.ordinal()]++;
    }

    /** Begins anew. */
    void clear() {
        impacts = 0;
        crushed = 0;
        contactSolves = 0;
        multiplications = 0;
        Arrays.fill(islandsBy, 0);
        Arrays.fill(rowsBy, 0);
    }
}

package rigibo.backend.contact.joint;

/**
 * Passes over the rows of an island whose elimination would do work (projected Gauss–Seidel), in
 * alternating directions, starting from the impulses of the last kick.
 */
final class RowPasses {

    private final NeutralRows rows;

    RowPasses(NeutralRows rows) {
        this.rows = rows;
    }

    /** Number of row solutions in the island. */
    private long solves;

    /** Begins an island. */
    void begin() {
        solves = 0;
    }

    /** Number of row solutions in the island. */
    long solves() {
        return solves;
    }

    /** Makes a number of passes, or fewer if no speed changes by more than {@code settled} m/s. */
    void run(int most, double settled) {
        double change = Double.POSITIVE_INFINITY;
        for (int pass = 0; pass < most && change > settled; pass++) {
            rows.bound();
            solves += rows.count;
            change = 0;
            for (int i = 0; i < rows.count; i++) {
                int row = pass % 2 == 0 ? i : rows.count - 1 - i;
                double changed = rows.inMetres(row, solve(row)) * rows.response[row];
                change = Math.max(change, changed);
            }
        }
    }

    private double solve(int row) {
        if (rows.load[row] != NeutralRows.NONE) {
            rows.bound(row);
        }
        double wish = rows.wish(row);
        double within = Math.max(rows.lower[row], Math.min(rows.upper[row], wish));
        double change = within - rows.impulse[row];
        rows.push(row, change);
        return change;
    }
}

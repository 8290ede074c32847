package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

/**
 * Passes over the rows of an island that is too large for elimination (projected Gauss-Seidel),
 * forth and back in turn, from the impulses of the kick before on.
 */
final class RowPasses {

    private final NeutralRows rows;

    /** By row: where it was before bodies were moved, m or rad. */
    private double[] before = new double[64];

    RowPasses(NeutralRows rows) {
        this.rows = rows;
    }

    /** Rows solved in the island. */
    private long solves;

    /** Begins an island. */
    void begin() {
        solves = 0;
    }

    /** Rows solved in the island, each as often as it was. */
    long solves() {
        return solves;
    }

    /** Makes so many passes, or fewer where nothing changes by more than some m/s. */
    void run(int most, double settled) {
        double change = Double.POSITIVE_INFINITY;
        for (int pass = 0; pass < most && change > settled; pass++) {
            rows.bound();
            solves += rows.count;
            change = 0;
            for (int i = 0; i < rows.count; i++) {
                int row = pass % 2 == 0 ? i : rows.count - 1 - i;
                change = Math.max(change, Math.abs(solve(row)) * rows.response[row]);
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

    /** Moves bodies so that the places of rows change by what is wanted, m or rad; 0 for none. */
    void move(int passes, double[] wanted) {
        if (before.length < rows.count) {
            before = new double[rows.bodies.length];
        }
        for (int row = 0; row < rows.count; row++) {
            before[row] = rows.along(row, Motions.DX);
        }
        for (int pass = 0; pass < passes; pass++) {
            for (int i = 0; i < rows.count; i++) {
                int row = pass % 2 == 0 ? i : rows.count - 1 - i;
                if (rows.holdsPlace[row] && (rows.isEquation(row) || wanted[row] > 0)) {
                    double left = wanted[row] - (rows.along(row, Motions.DX) - before[row]);
                    rows.move(row, left / rows.response[row], Motions.DX);
                }
            }
        }
    }
}

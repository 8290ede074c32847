package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

/** Stored velocities and impulses of an island, to which it can be restored. */
final class RowMemory {

    private final Motions motions;
    private final NeutralRows rows;
    private double[] bodies = new double[64];
    private double[] impulses = new double[64];

    RowMemory(Motions motions, NeutralRows rows) {
        this.motions = motions;
        this.rows = rows;
    }

    void keep() {
        int length = motions.count * Motions.STRIDE;
        if (bodies.length < length) {
            bodies = new double[motions.data.length];
        }
        if (impulses.length < rows.count) {
            impulses = new double[rows.bodies.length];
        }
        System.arraycopy(motions.data, 0, bodies, 0, length);
        System.arraycopy(rows.impulse, 0, impulses, 0, rows.count);
    }

    void recall() {
        System.arraycopy(bodies, 0, motions.data, 0, motions.count * Motions.STRIDE);
        System.arraycopy(impulses, 0, rows.impulse, 0, rows.count);
    }

    /**
     * Applies all impulses again to the stored velocities, which must be those without any. This
     * removes the round-off of huge intermediate impulses, which no row sees in directions that
     * none holds.
     */
    void redo() {
        System.arraycopy(bodies, 0, motions.data, 0, motions.count * Motions.STRIDE);
        for (int row = 0; row < rows.count; row++) {
            if (rows.impulse[row] != 0) {
                rows.apply(row, rows.impulse[row]);
            }
        }
    }
}

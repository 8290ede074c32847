package rigibo.backend.contact;

/**
 * Goes half of the way that a round of the solver went. Friction holds what is pressed, and presses
 * what it holds: rounds can chase each other in a circle, and the middle of a circle is nearer to
 * what they look for than any point of it. Bounds are kept, for they are convex.
 */
final class Halfway {

    private final Motions motions;
    private final Rows rows;

    /** The velocities and impulses that a round began with, laid out as motions and rows. */
    private double[] velocities = new double[64];

    private double[] impulses = new double[64];

    Halfway(Motions motions, Rows rows) {
        this.motions = motions;
        this.rows = rows;
    }

    /** Remembers where a round begins. */
    void begin() {
        int moving = motions.count * Motions.STRIDE;
        int touching = rows.count * Rows.STRIDE;
        if (velocities.length < moving) {
            velocities = new double[motions.data.length];
        }
        if (impulses.length < touching) {
            impulses = new double[rows.data.length];
        }
        System.arraycopy(motions.data, 0, velocities, 0, moving);
        System.arraycopy(rows.data, 0, impulses, 0, touching);
    }

    /** Takes half of the round back. */
    void end() {
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            for (int column = at; column < at + Motions.DX; column++) {
                motions.data[column] = (motions.data[column] + velocities[column]) / 2;
            }
        }
        for (int at = 0; at < rows.count * Rows.STRIDE; at += Rows.STRIDE) {
            halve(at + Rows.IMPULSE0);
            halve(at + Rows.IMPULSE1);
            halve(at + Rows.IMPULSE_T);
            halve(at + Rows.IMPULSE_R);
        }
    }

    /** Takes all of the round back. */
    void takeBack() {
        System.arraycopy(velocities, 0, motions.data, 0, motions.count * Motions.STRIDE);
        System.arraycopy(impulses, 0, rows.data, 0, rows.count * Rows.STRIDE);
    }

    private void halve(int column) {
        rows.data[column] = (rows.data[column] + impulses[column]) / 2;
    }
}

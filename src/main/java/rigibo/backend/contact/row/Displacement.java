package rigibo.backend.contact.row;

/** Displacements of the packed island's bodies since a stored state; they can be scaled down. */
public final class Displacement {

    private final Motions motions;

    /** The stored state, laid out as the motions. */
    private double[] before = new double[16 * Motions.STRIDE];

    public Displacement(Motions motions) {
        this.motions = motions;
    }

    /** Stores the places of all bodies. */
    public void begin() {
        int length = motions.count * Motions.STRIDE;
        if (before.length < length) {
            before = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, before, 0, length);
    }

    /** Change of a column of the motions since the stored state, m or rad. */
    public double of(int column) {
        return motions.data[column] - before[column];
    }

    /** Scales the displacement of the body at an offset. */
    public void scale(int at, double share) {
        for (int column = at + Motions.DX; column <= at + Motions.TURN; column++) {
            motions.data[column] = before[column] + share * of(column);
        }
    }

    /** Scales the displacements of all bodies. */
    public void scaleAll(double share) {
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            scale(at, share);
        }
    }
}

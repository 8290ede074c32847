package rigibo.backend.contact.row;

/** How far bodies of the packed island were moved since a moment, of which a share can be left. */
public final class Displacement {

    private final Motions motions;

    /** How bodies were at that moment, laid out as the motions. */
    private double[] before = new double[16 * Motions.STRIDE];

    public Displacement(Motions motions) {
        this.motions = motions;
    }

    /** Notes where all bodies are. */
    public void begin() {
        int length = motions.count * Motions.STRIDE;
        if (before.length < length) {
            before = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, before, 0, length);
    }

    /** By how much a column of the motions has grown since, m or rad. */
    public double of(int column) {
        return motions.data[column] - before[column];
    }

    /** Leaves a share of what moved the body at an offset. */
    public void scale(int at, double share) {
        for (int column = at + Motions.DX; column <= at + Motions.TURN; column++) {
            motions.data[column] = before[column] + share * of(column);
        }
    }

    /** Leaves a share of what moved all bodies. */
    public void scaleAll(double share) {
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            scale(at, share);
        }
    }
}

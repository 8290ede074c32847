package rigibo.backend.contact.row;

/** Contacts that do not stay as they were measured when the step began. */
public final class BentRows {

    private final PackedContacts contacts;
    private final FreshRows fresh;

    /** How bodies turn, or null where none does. */
    private final TurningRows turning;

    /** How normals turn along the way, or null where that is not followed. */
    private final CurvedRows curved;

    /** Whether anything is bent in this part of a substep, or was in the one before. */
    private boolean isAnyNow;

    private boolean wasAny;

    /** Whether there was anything since the packed island began, where it is followed. */
    private boolean isAnyBent;

    /** By row whether its outlines turn, and whether its normal does. */
    private boolean[] turns = new boolean[16];

    private boolean[] curves = new boolean[16];

    public BentRows(
            PackedContacts contacts, FreshRows fresh, TurningRows turning, CurvedRows curved) {
        this.contacts = contacts;
        this.fresh = fresh;
        this.turning = turning;
        this.curved = curved;
    }

    /** Begins a packed island. */
    public void begin() {
        isAnyNow = false;
        isAnyBent = false;
    }

    /** Whether a normal or an outline has turned since the packed island began. */
    public boolean isAnyBent() {
        return isAnyBent;
    }

    /**
     * Measures anew what has turned, or gone round, too far or is about to, with {@code left}
     * seconds of the step to go, and edges of a chain that something may have come over; what was
     * measured as the first part of a substep begins is new.
     *
     * @return whether there was anything
     */
    public boolean refresh(int substep, boolean isFirst, double left) {
        if (turning != null) {
            turning.begin(left);
        }
        reserve();
        boolean isCrowd = contacts.areCrowd();
        boolean isAny = false;
        boolean isAnyNew = false;
        for (int row = 0; row < contacts.count; row++) {
            turns[row] = turning != null && turning.isTurning(row, left);
            curves[row] = curved != null && curved.isCurved(row, left);
            boolean isBent = turns[row] || curves[row];
            isAny |= isBent;
            boolean isAwaited = fresh.isAwaited(row);
            if (isBent || isAwaited) {
                boolean isNew = isFirst && (substep == 0 || contacts.firstSubstep[row] == substep);
                // In a crowd half of the contacts are only foreseen, and stay so; so do most edges
                // of a chain that something is near.
                if (!isNew && (!isCrowd && !isAwaited || fresh.mayClose(row, left))) {
                    fresh.measure(row, left);
                    isAnyNew = true;
                }
            }
        }
        wasAny = isAnyNow;
        isAnyNow = isAny;
        isAnyBent |= isAny && curved != null;
        return isAny || isAnyNew;
    }

    /** How long the points of what slides from one face to the next are all that there are, s. */
    public double untilNewPoints() {
        double until = Double.POSITIVE_INFINITY;
        for (int row = 0; isAnyNow && row < contacts.count; row++) {
            if (curves[row]) {
                until = Math.min(until, curved.untilNewPoint(row));
            }
        }
        return until;
    }

    private void reserve() {
        if (turns.length < contacts.count) {
            turns = new boolean[contacts.pair.length];
            curves = new boolean[contacts.pair.length];
        }
    }

    /**
     * Predicts how far gaps open by turning within h seconds; those of curves within the time in
     * which gaps may close.
     */
    public void bend(double h, double closing) {
        if (!isAnyNow && !wasAny) {
            return;
        }
        for (int row = 0; row < contacts.count; row++) {
            if (turns[row]) {
                turning.bend(row, h);
            } else if (turning != null) {
                turning.straighten(row);
            }
            if (curves[row]) {
                curved.bend(row, closing);
            }
        }
    }
}

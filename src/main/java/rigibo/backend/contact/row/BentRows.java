package rigibo.backend.contact.row;

import rigibo.backend.team.Team;

/** Contacts whose outlines or normals turn within the step, and which are measured again. */
public final class BentRows {

    private final PackedContacts contacts;
    private final FreshRows fresh;

    /** Contacts of turning bodies; null without rotation. */
    private final TurningRows turning;

    /** Contacts with turning normals; null if these are not followed. */
    private final CurvedRows curved;

    /** Whether any contact is bent in this part of a substep. */
    private boolean isAnyNow;

    /** Whether any contact was bent in the last part. */
    private boolean wasAny;

    /**
     * Whether any contact was bent since the start of the packed island, if curves are followed.
     */
    private boolean isAnyBent;

    /** By row: whether its outlines turn. */
    private boolean[] turns = new boolean[16];

    /** By row: whether its normal turns. */
    private boolean[] curves = new boolean[16];

    /** By row: whether it is measured in this part. */
    private boolean[] measured = new boolean[16];

    private final Team.Pieces lookingPieces = this::lookAt;
    private final SharedRows shared;

    /**
     * Parameters of the present part: the number of its substep, whether it is the first in it, and
     * the time left in the step, s.
     */
    private int substep;

    private boolean isFirst;
    private double left;

    /** Whether the packed island is a crowd. */
    private boolean isCrowd;

    public BentRows(
            PackedContacts contacts,
            FreshRows fresh,
            TurningRows turning,
            CurvedRows curved,
            SharedRows shared) {
        this.contacts = contacts;
        this.shared = shared;
        this.fresh = fresh;
        this.turning = turning;
        this.curved = curved;
    }

    /** Starts a packed island. */
    public void begin() {
        isAnyNow = false;
        isAnyBent = false;
    }

    /** Whether a normal or an outline has turned since the packed island began. */
    public boolean isAnyBent() {
        return isAnyBent;
    }

    /**
     * Measures again the contacts whose outlines or normals turn too far in the rest ({@code left}
     * s) of the step, and edges of chains that a body may have come over. Contacts that were
     * measured at the start of this substep are left out.
     *
     * @return whether any contact is bent or was measured
     */
    public boolean refresh(int substep, boolean isFirst, double left) {
        if (turning != null) {
            turning.begin(left);
        }
        reserve();
        this.substep = substep;
        this.isFirst = isFirst;
        this.left = left;
        isCrowd = contacts.areCrowd();
        boolean isShared = shared.areWorthwhile() && fresh.isShareable();
        if (isShared) {
            shared.each(contacts.count, lookingPieces);
            fresh.measure(measured, left);
        }
        boolean isAny = false;
        boolean isAnyNew = false;
        for (int row = 0; row < contacts.count; row++) {
            if (!isShared) {
                lookAt(row, row + 1, 0);
                measureIfMarked(row);
            }
            isAny |= turns[row] || curves[row];
            isAnyNew |= measured[row];
        }
        wasAny = isAnyNow;
        isAnyNow = isAny;
        isAnyBent |= isAny && curved != null;
        return isAny || isAnyNew;
    }

    private void measureIfMarked(int row) {
        if (measured[row]) {
            fresh.measure(row, left);
        }
    }

    /** Finds which contacts turn, and which of them are measured again. */
    private void lookAt(int from, int to, int worker) {
        for (int row = from; row < to; row++) {
            turns[row] = turning != null && turning.isTurning(row);
            curves[row] = curved != null && curved.isCurved(row, left);
            boolean isAwaited = fresh.isAwaited(row);
            boolean isNew = isFirst && (substep == 0 || contacts.firstSubstep[row] == substep);
            // In a crowd half of the contacts are predicted but never close; so are most edges of a
            // chain near a body.
            measured[row] =
                    (turns[row] || curves[row] || isAwaited)
                            && !isNew
                            && (!isCrowd && !isAwaited || fresh.mayClose(row, left));
        }
    }

    /** Time in s for which bodies that slide from one face to the next have no further points. */
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
            measured = new boolean[contacts.pair.length];
        }
    }

    /**
     * Predicts how far gaps open by turning outlines within h seconds, and by turning normals
     * within {@code closing} seconds, in which gaps may close.
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

package rigibo.backend.saved;

import rigibo.backend.geometry.Compound;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;

/**
 * A contact that an edit took from the pairs, as a snapshot keeps it.
 *
 * @param a slot of the body the normal points away from, the lower one
 * @param b slot of the body the normal points to
 * @param partA which part of A's shape touched, from 0
 * @param partB which part of B's shape touched
 * @param isCut whether it was taken since the last step, or the last step told its end
 * @param phase 0, 1, 2: what the last step told of it: that it began, persisted or ended
 * @param x world x, m
 * @param y world y, m
 * @param normalX unit normal from a to b
 * @param normalY unit normal from a to b
 * @param impulse N·s
 * @param isCrushing whether something driven was pressed in deep
 */
public record SavedContact(
        int a,
        int b,
        int partA,
        int partB,
        boolean isCut,
        int phase,
        double x,
        double y,
        double normalX,
        double normalY,
        double impulse,
        boolean isCrushing) {

    /** Two slots, two parts, the phase, two flags, five numbers. */
    static final int BYTES = 5 * Integer.BYTES + 2 + 5 * Double.BYTES;

    private static final int LAST_PHASE = 2;

    /** What is handed to a codec that reads. */
    static final SavedContact UNREAD = new SavedContact(0, 1, 0, 0, true, 0, 0, 0, 0, 0, 0, false);

    SavedContact visit(Codec codec) {
        return new SavedContact(
                codec.number(a),
                codec.number(b),
                codec.number(partA),
                codec.number(partB),
                codec.flag(isCut),
                codec.number(phase),
                codec.number(x),
                codec.number(y),
                codec.number(normalX),
                codec.number(normalY),
                codec.number(impulse),
                codec.flag(isCrushing));
    }

    /**
     * Refuses what no pool can have told.
     *
     * @throws IllegalArgumentException naming what is wrong
     */
    void require(Bodies bodies) {
        SnapshotCheck.requireBodyAt("an ended contact", bodies, a);
        SnapshotCheck.requireBodyAt("an ended contact", bodies, b);
        if (a >= b) {
            throw new IllegalArgumentException(
                    "an ended contact must name the lower slot first, was " + a + " and " + b);
        }
        Require.within("an ended contact's partA", partA, 0, Compound.MAX_PARTS - 1);
        Require.within("an ended contact's partB", partB, 0, Compound.MAX_PARTS - 1);
        Require.within("an ended contact's phase", phase, 0, LAST_PHASE);
        Require.finite("an ended contact's x", x, "m");
        Require.finite("an ended contact's y", y, "m");
        Require.finite("an ended contact's normalX", normalX, "no unit");
        Require.finite("an ended contact's normalY", normalY, "no unit");
        Require.notNegative("an ended contact's impulse", impulse, "N·s");
    }
}

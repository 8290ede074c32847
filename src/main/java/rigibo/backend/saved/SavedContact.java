package rigibo.backend.saved;

import rigibo.backend.geometry.Compound;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;

/**
 * A contact that an edit removed from the pairs, as a snapshot keeps it.
 *
 * @param a slot of the body from which the normal points away, the lower one
 * @param b slot of the body to which the normal points
 * @param partA number of the part of A's shape that touched, from 0
 * @param partB number of the part of B's shape that touched
 * @param isCut whether it was removed after the last step; if not, the last step reported its end
 * @param phase what the last step reported: 0 begun, 1 persisting, 2 ended
 * @param x world x, m
 * @param y world y, m
 * @param normalX x of the unit normal from a to b
 * @param normalY y of the unit normal from a to b
 * @param impulse N·s
 * @param isCrushing whether a driven body overlapped the other one too deeply
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

    /** Passed to a codec that reads. */
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
     * Rejects a contact that no pool can have reported.
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

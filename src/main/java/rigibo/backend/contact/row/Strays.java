package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/**
 * Bodies that move farther in a step than was predicted when it began, because they or their
 * supports were struck. Their contacts were measured for a shorter distance, and a second corner
 * may land that was too far away to be a point. Islands of few bodies are left out: {@link
 * Landings} follow every landing there, and a body crushed between two walls would be measured
 * against one and then the other.
 */
public final class Strays {

    /** Excess over the predicted distance that is neglected, in widths. */
    private static final double UNSEEN = 1e-3;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Motions motions;
    private final PackedContacts contacts;

    /** By entry of the motions: largest predicted displacement of its outline, m. */
    private double[] foreseen = new double[16];

    private boolean[] strays = new boolean[16];

    public Strays(DataStorage data, Motions motions, PackedContacts contacts) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.motions = motions;
        this.contacts = contacts;
    }

    /**
     * Predicts the displacements of the packed bodies for the rest ({@code left} s) of the step.
     */
    public void begin(double left) {
        if (motions.areFew()) {
            return;
        }
        if (foreseen.length < motions.count) {
            foreseen = new double[motions.slots.length];
            strays = new boolean[motions.slots.length];
        }
        strays[0] = false;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            double pull =
                    Math.abs(bodies.accelerationX[slot]) + Math.abs(bodies.accelerationY[slot]);
            double unseen = UNSEEN * bodies.smallestWidth[slot];
            foreseen[entry] = way(entry, left) + pull * left * left + unseen;
        }
    }

    /** Finds strays for the rest ({@code left} s) of the step; returns whether there are any. */
    public boolean areAny(double left) {
        if (motions.areFew()) {
            return false;
        }
        boolean isAny = false;
        for (int entry = 1; entry < motions.count; entry++) {
            strays[entry] = way(entry, left) > foreseen[entry];
            isAny |= strays[entry];
        }
        return isAny;
    }

    /** Largest displacement of an entry's outline up to the end of the step, m. */
    private double way(int entry, double left) {
        double[] m = motions.data;
        int at = entry * Motions.STRIDE;
        double moved = Math.abs(m[at + Motions.DX]) + Math.abs(m[at + Motions.DY]);
        double speed = Math.abs(m[at + Motions.VX]) + Math.abs(m[at + Motions.VY]);
        double turned = Math.abs(m[at + Motions.TURN]) + left * Math.abs(m[at + Motions.SPIN]);
        return moved + left * speed + motions.reach[entry] * turned;
    }

    /** Whether a corner may land that a contact of a stray does not have as a point yet. */
    public boolean mayLackPoint(int row) {
        int a = contacts.bodyA[row] / Motions.STRIDE;
        int b = contacts.bodyB[row] / Motions.STRIDE;
        int pair = contacts.pair[row];
        return contacts.points[row] == 1
                && (strays[a] || strays[b])
                && !bodies.outline[pairs.shapeA(pair)].isDisc()
                && !bodies.outline[pairs.shapeB(pair)].isDisc();
    }
}

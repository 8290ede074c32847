package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Islands;

import java.util.Arrays;

/**
 * Bodies that join an island within a step. A body that joins at time t takes part from the substep
 * that contains t. It is moved back along its straight path to where it would have been when the
 * island's substeps began, so that its impact comes at the right time. Its contacts start without
 * impulses.
 */
public final class LateJoiners {

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;

    /** By entry of the motions: the substep in which it joins. */
    private int[] joinsIn = new int[16];

    /** By entry of the motions: when it joined before it was delayed, s after the step's start. */
    private double[] joined = new double[16];

    public LateJoiners(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Time at which the first of an island's bodies joined, s after the step's start. */
    public double startOf(Islands islands, int island) {
        double first = Double.POSITIVE_INFINITY;
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            first = Math.min(first, bodies.pileTime[islands.bodies[i]]);
        }
        return first;
    }

    /** Delays the late joiners of the packed island, whose substeps of h s begin at a time, s. */
    public void delay(double start, double h) {
        boolean isAny = false;
        if (joinsIn.length < motions.count) {
            joinsIn = new int[motions.slots.length];
        }
        Arrays.fill(joinsIn, 0, motions.count, PackedContacts.ALWAYS);
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            int slot = motions.slots[entry];
            if (bodies.isDriven(slot)) {
                // Its place is that at the step's start, but the island starts later.
                motions.drift(at, start);
            } else if (bodies.pileTime[slot] > 0) {
                double late = bodies.pileTime[slot] - start;
                // Drift moves it from the island's start on, so it is moved back by that distance.
                motions.drift(at, -late);
                joinsIn[entry] = (int) (late / h);
                isAny = true;
            }
        }
        if (isAny) {
            delayRows();
        }
    }

    /**
     * Delays the late joiners of the packed island to the start of the substep of h seconds in
     * which they join, by moving them back along their parabola. From there on they move as all
     * other bodies do, so that they meet others in that substep at their true speed.
     */
    public void delayToSubsteps(double h) {
        double[] m = motions.data;
        boolean isAny = false;
        if (joinsIn.length < motions.count) {
            joinsIn = new int[motions.slots.length];
        }
        if (joined.length < motions.count) {
            joined = new double[motions.slots.length];
        }
        Arrays.fill(joinsIn, 0, motions.count, PackedContacts.ALWAYS);
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            int slot = motions.slots[entry];
            double late = bodies.pileTime[slot];
            joined[entry] = late;
            if (!bodies.isDriven(slot) && late > 0) {
                joinsIn[entry] = (int) (late / h);
                double since = late - joinsIn[entry] * h;
                m[at + Motions.VX] -= since * bodies.accelerationX[slot];
                m[at + Motions.VY] -= since * bodies.accelerationY[slot];
                if (motions.turns) {
                    m[at + Motions.SPIN] -= since * bodies.angularAcceleration[slot];
                    m[at + Motions.TURN] -= since * since / 2 * bodies.angularAcceleration[slot];
                }
                motions.drift(at, -late);
                m[at + Motions.DX] -= since * since / 2 * bodies.accelerationX[slot];
                m[at + Motions.DY] -= since * since / 2 * bodies.accelerationY[slot];
                bodies.pileTime[slot] = joinsIn[entry] * h;
                isAny = true;
            }
        }
        if (isAny) {
            delayRows();
        }
    }

    /**
     * Restores the times at which the bodies of the packed island joined, before it is solved
     * again: their stored places are those of these times.
     */
    public void restoreTimes() {
        for (int entry = 1; entry < motions.count; entry++) {
            bodies.pileTime[motions.slots[entry]] = joined[entry];
        }
    }

    private void delayRows() {
        for (int row = 0; row < contacts.count; row++) {
            int joinsA = joinsIn[contacts.bodyA[row] / Motions.STRIDE];
            int joinsB = joinsIn[contacts.bodyB[row] / Motions.STRIDE];
            int joins = Math.max(joinsA, joinsB);
            if (joins != PackedContacts.ALWAYS) {
                contacts.joinsIn(row, joins);
            }
        }
    }
}

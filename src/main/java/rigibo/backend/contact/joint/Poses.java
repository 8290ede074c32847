package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.geometry.Angle;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/** Poses of the bodies of a packed island, at present or predicted by their velocities. */
final class Poses {

    private final Bodies bodies;
    private final Motions motions;

    /**
     * By entry: the displacement since the start of the step, m; and the angle in rad, its cosine
     * and its sine.
     */
    private double[] x = new double[0];

    private double[] y = new double[0];
    private double[] angle = new double[0];
    private double[] cos = new double[0];
    private double[] sin = new double[0];

    Poses(Bodies bodies, Motions motions) {
        this.bodies = bodies;
        this.motions = motions;
    }

    /** Computes the poses after some seconds at the present velocities. */
    void take(double ahead) {
        if (x.length < motions.count) {
            int capacity = motions.slots.length;
            x = new double[capacity];
            y = new double[capacity];
            angle = new double[capacity];
            cos = new double[capacity];
            sin = new double[capacity];
            // NaN marks that sine and cosine have not been computed.
            Arrays.fill(angle, Double.NaN);
        }
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            int slot = motions.slots[entry];
            x[entry] = m[at + Motions.DX] + ahead * m[at + Motions.VX];
            y[entry] = m[at + Motions.DY] + ahead * m[at + Motions.VY];
            double turn = m[at + Motions.TURN] + ahead * m[at + Motions.SPIN];
            double now = bodies.angle[slot] + turn;
            // Sine and cosine are stored, since most are needed again after the drift that was
            // predicted.
            if (now != angle[entry]) {
                angle[entry] = now;
                cos[entry] = turn == 0 ? bodies.cos[slot] : Angle.cos(now);
                sin[entry] = turn == 0 ? bodies.sin[slot] : Angle.sin(now);
            }
        }
    }

    /** Displacement of a body since the start of the step, m; 0 if it is not packed. */
    double movedX(int offset) {
        return offset == 0 ? 0 : x[offset / Motions.STRIDE];
    }

    double movedY(int offset) {
        return offset == 0 ? 0 : y[offset / Motions.STRIDE];
    }

    /** rad. */
    double angle(int slot, int offset) {
        return offset == 0 ? bodies.angle[slot] : angle[offset / Motions.STRIDE];
    }

    double cos(int slot, int offset) {
        return offset == 0 ? bodies.cos[slot] : cos[offset / Motions.STRIDE];
    }

    double sin(int slot, int offset) {
        return offset == 0 ? bodies.sin[slot] : sin[offset / Motions.STRIDE];
    }
}

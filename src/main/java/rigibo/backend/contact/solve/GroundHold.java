package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.DX;
import static rigibo.backend.contact.row.Motions.DY;
import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.TURN;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

/**
 * Keeps what is pushed out of other bodies from being pushed into what does not move: whatever is
 * deeper in the ground once overlap was taken back than it was to be goes back by as much. Its
 * neighbours keep that much more of their overlap: where something must give, bodies that move do.
 */
final class GroundHold {

    /** Passes over the contacts with the ground: a body in a corner has two. */
    private static final int PASSES = 4;

    private final Motions motions;
    private final PackedContacts contacts;

    /** By point of a contact: the gap that it is to have in the end, at most 0, m. */
    private double[] wanted = new double[32];

    GroundHold(Motions motions, PackedContacts contacts) {
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Notes how deep everything is in the ground before overlap is taken back. */
    void begin() {
        if (wanted.length < 2 * contacts.count) {
            wanted = new double[2 * contacts.pair.length];
        }
        for (int row = contacts.groundStart; row < contacts.count; row++) {
            for (int point = 0; point < contacts.points[row]; point++) {
                wanted[2 * row + point] = Math.min(0, motions.gap(contacts, row, point));
            }
        }
    }

    /** Has a point that is in the ground come out by so much, m. */
    void open(int row, int point, double by) {
        wanted[2 * row + point] += by;
    }

    /** Takes back what went deeper, in contacts that are there in a substep. */
    void hold(int substep) {
        for (int pass = 0; pass < PASSES; pass++) {
            for (int row = contacts.groundStart; row < contacts.count; row++) {
                if (contacts.firstSubstep[row] <= substep) {
                    for (int point = 0; point < contacts.points[row]; point++) {
                        hold(row, point);
                    }
                }
            }
        }
    }

    private void hold(int row, int point) {
        double deeper = wanted[2 * row + point] - motions.gap(contacts, row, point);
        if (deeper <= 0) {
            return;
        }
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        double response = d[at + (point == 0 ? PackedContacts.K00 : PackedContacts.K11)];
        double push = deeper / response;
        double x = push * d[at + PackedContacts.NX];
        double y = push * d[at + PackedContacts.NY];
        move(contacts.bodyA[row], -x, -y, -push * d[at + 2 * point + PackedContacts.LEVER_A0]);
        move(contacts.bodyB[row], x, y, push * d[at + 2 * point + PackedContacts.LEVER_B0]);
    }

    private void move(int body, double x, double y, double turn) {
        double[] m = motions.data;
        m[body + DX] += m[body + INVERSE_MASS] * x;
        m[body + DY] += m[body + INVERSE_MASS] * y;
        m[body + TURN] += m[body + INVERSE_INERTIA] * turn;
    }
}

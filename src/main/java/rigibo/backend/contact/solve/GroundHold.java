package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.DX;
import static rigibo.backend.contact.row.Motions.DY;
import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.TURN;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

/**
 * Keeps removal of overlap from pushing bodies into immovable ones. A body that is afterwards
 * deeper in the ground than intended is moved back by the difference. Its neighbours then keep that
 * much more of their overlap with it, since between movable bodies and the ground the former must
 * yield.
 */
final class GroundHold {

    /** Passes over the contacts with the ground; a body in a corner has two. */
    private static final int PASSES = 4;

    private final Motions motions;
    private final PackedContacts contacts;

    /** By point: least gap wanted in the end, at most 0, m. */
    private double[] wanted = new double[32];

    GroundHold(Motions motions, PackedContacts contacts) {
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Stores the overlaps with the ground before overlap is removed. */
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

    /** Lets a point in the ground come out by a distance, m. */
    void open(int row, int point, double by) {
        wanted[2 * row + point] += by;
    }

    /** Moves back bodies that went deeper, at the contacts that take part in a substep. */
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

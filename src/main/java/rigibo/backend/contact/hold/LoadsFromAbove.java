package rigibo.backend.contact.hold;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.KeptOverlap;

import java.util.Arrays;

/**
 * Hands the loads of a pile down from body to body, starting at the highest. When a body's turn
 * comes, the loads on it from above are known, so the forces of its supports follow from the
 * statics of this one body, whatever stands below. In a stack of a hundred storeys one such pass
 * finds the loads that passes over the contacts only approach after thousands, since those carry a
 * load one storey further at a time. (It is the opposite of shock propagation, which goes from the
 * ground up: E. Guendelman, R. Bridson and R. Fedkiw, Nonconvex Rigid Bodies with Stacking, 2003.)
 *
 * <p>Where bodies lean on each other sideways, as the stones of an arch do, a body is left
 * unsupported, and the result is not used.
 */
final class LoadsFromAbove {

    /**
     * Largest remaining speed of a body, as a share of the speed that its pull and its supports
     * give it.
     */
    private static final double UNHELD = 1e-10;

    /**
     * Gap that counts as closed in a crowd, as a share of the overlap that a calm one keeps. Boxes
     * of a pyramid that hang between two corners sway on them for good, by micrometres, and come
     * near the points that would hold them.
     */
    private static final double CLOSED_IN_A_CROWD = 0.2;

    /** Rounds continue as long as each leaves at most this share of the body's remaining speed. */
    private static final double IMPROVES = 0.5;

    /** Most rounds over the contacts of one body, with normals alone and with friction each. */
    private static final int ROUNDS = 100;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;

    /** Gap in widths that counts as closed in a crowd. */
    private final double closedInACrowd;

    /** The packed bodies from the highest down: depth and entry, packed into one number each. */
    private long[] order = new long[16];

    /** By entry: its place in the order. */
    private int[] place = new int[16];

    /** The contacts on which an entry lies: supports[start[e]] to supports[start[e + 1]]. */
    private int[] start = new int[17];

    private int[] supports = new int[16];

    LoadsFromAbove(Bodies bodies, Motions motions, PackedContacts contacts, Accuracy accuracy) {
        closedInACrowd = CLOSED_IN_A_CROWD * KeptOverlap.ifCalm(true, accuracy);
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
    }

    /**
     * Finds impulses of the packed island's contacts that hold all bodies.
     *
     * @param kicked length of the kick to be balanced, s
     * @return whether every body is held; if not, impulses and velocities are meaningless
     */
    boolean handDown(double kicked) {
        reserve();
        sort();
        listSupports();
        for (int i = 1; i < motions.count; i++) {
            int entry = (int) order[i];
            boolean isMovable = motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS] > 0;
            if (isMovable && !hold(entry, kicked)) {
                return false;
            }
        }
        return true;
    }

    private void reserve() {
        if (order.length < motions.count) {
            order = new long[motions.slots.length];
            place = new int[motions.slots.length];
            start = new int[motions.slots.length + 1];
        }
        if (supports.length < contacts.count) {
            supports = new int[contacts.pair.length];
        }
    }

    /** Sorts bodies by their depth along their common pull, ties by entry. */
    private void sort() {
        double pullX = 0;
        double pullY = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            double inverse = motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS];
            if (inverse > 0) {
                pullX += bodies.accelerationX[motions.slots[entry]] / inverse;
                pullY += bodies.accelerationY[motions.slots[entry]] / inverse;
            }
        }
        double pull = Math.sqrt(pullX * pullX + pullY * pullY);
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            double depth = pull > 0 ? (pullX * bodies.x[slot] + pullY * bodies.y[slot]) / pull : 0;
            order[entry] = (long) ascending((float) depth) << Integer.SIZE | entry;
        }
        Arrays.sort(order, 1, motions.count);
        place[0] = motions.count;
        for (int i = 1; i < motions.count; i++) {
            place[(int) order[i]] = i;
        }
    }

    /** Maps a double to bits of the same order. */
    private static int ascending(float number) {
        int bits = Float.floatToIntBits(number);
        return bits < 0 ? bits ^ Integer.MAX_VALUE : bits;
    }

    /**
     * Counts each body's supports, turns counts into starts, and fills the lists from their ends.
     */
    private void listSupports() {
        Arrays.fill(start, 0, motions.count + 1, 0);
        for (int row = 0; row < contacts.count; row++) {
            start[upper(row)]++;
        }
        for (int entry = 1; entry <= motions.count; entry++) {
            start[entry] += start[entry - 1];
        }
        for (int row = contacts.count - 1; row >= 0; row--) {
            supports[--start[upper(row)]] = row;
        }
    }

    /** The higher of two bodies; an immovable body is below all others. */
    private int upper(int row) {
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        boolean canMoveA = motions.data[a + Motions.INVERSE_MASS] > 0;
        boolean canMoveB = motions.data[b + Motions.INVERSE_MASS] > 0;
        int entryA = a / Motions.STRIDE;
        int entryB = b / Motions.STRIDE;
        if (canMoveA != canMoveB) {
            return canMoveA ? entryA : entryB;
        }
        return place[entryA] < place[entryB] ? entryA : entryB;
    }

    /**
     * Finds impulses that hold one body on its supports as if these were fixed; returns whether
     * they do. Normal impulses come first, since unneeded friction would push the bodies below
     * apart.
     */
    private boolean hold(int entry, double kicked) {
        double most = 0;
        double left = speed(entry);
        double before;
        int round = 0;
        // Carried impulses may exceed bounds that have changed, so every contact is solved once.
        do {
            for (int i = start[entry]; i < start[entry + 1]; i++) {
                carry(supports[i], entry * Motions.STRIDE, round >= ROUNDS);
            }
            before = left;
            left = speed(entry);
            most = UNHELD * own(entry, kicked);
        } while (++round < 2 * ROUNDS && (left > most || left < IMPROVES * before));
        return left <= most;
    }

    /** Speed that a body's pull and its supports give it in a kick, m/s. */
    private double own(int entry, double kicked) {
        double carried = 0;
        for (int i = start[entry]; i < start[entry + 1]; i++) {
            int at = supports[i] * PackedContacts.STRIDE;
            carried += contacts.data[at + PackedContacts.IMPULSE0];
            carried += contacts.data[at + PackedContacts.IMPULSE1];
        }
        int slot = motions.slots[entry];
        double pull = Math.abs(bodies.accelerationX[slot]) + Math.abs(bodies.accelerationY[slot]);
        return kicked * pull
                + carried * motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS];
    }

    /** Highest speed of any point of a body, m/s. */
    private double speed(int entry) {
        double[] m = motions.data;
        int at = entry * Motions.STRIDE;
        double straight = Math.abs(m[at + Motions.VX]) + Math.abs(m[at + Motions.VY]);
        double radius = bodies.boundingRadius[motions.slots[entry]];
        return straight + radius * Math.abs(m[at + Motions.SPIN]);
    }

    private void carry(int row, int body, boolean rubs) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        boolean isB = contacts.bodyB[row] == body;
        int other = isB ? contacts.bodyA[row] : contacts.bodyB[row];
        int own = at + (isB ? PackedContacts.LEVER_B0 : PackedContacts.LEVER_A0);
        int others = at + (isB ? PackedContacts.LEVER_A0 : PackedContacts.LEVER_B0);
        double side = isB ? 1 : -1;
        double nx = side * d[at + PackedContacts.NX];
        double ny = side * d[at + PackedContacts.NY];
        double load = 0;
        for (int point = 0; point < contacts.points[row]; point++) {
            double before = d[at + PackedContacts.IMPULSE0 + point];
            if (before > 0 || isClosed(row, point)) {
                double lever = side * d[own + 2 * point];
                double after = Math.max(0, before + wanted(body, nx, ny, lever));
                d[at + PackedContacts.IMPULSE0 + point] = after;
                push(body, other, nx, ny, lever, side * d[others + 2 * point], after - before);
                load += after;
            }
        }
        double before = d[at + PackedContacts.IMPULSE_T];
        double lever = side * d[at + (isB ? PackedContacts.LEVER_TB : PackedContacts.LEVER_TA)];
        double after = before + (rubs ? wanted(body, -ny, nx, lever) : 0);
        double cone = d[at + PackedContacts.FRICTION] * load;
        after = Math.max(-cone, Math.min(cone, after));
        d[at + PackedContacts.IMPULSE_T] = after;
        double otherLever =
                side * d[at + (isB ? PackedContacts.LEVER_TA : PackedContacts.LEVER_TB)];
        push(body, other, -ny, nx, lever, otherLever, after - before);
    }

    /** Whether a point carries if its body needs it. */
    private boolean isClosed(int row, int point) {
        double width = contacts.width(row);
        double most = contacts.areCrowd() ? closedInACrowd : Stillness.STILL;
        return motions.gap(contacts, row, point) <= most * width;
    }

    /** Impulse along a row that stops a body on an immovable one, N·s. */
    private double wanted(int body, double nx, double ny, double lever) {
        double[] m = motions.data;
        double speed = nx * m[body + Motions.VX] + ny * m[body + Motions.VY];
        speed += lever * m[body + Motions.SPIN];
        double response = m[body + Motions.INVERSE_MASS];
        response += m[body + Motions.INVERSE_INERTIA] * lever * lever;
        return -speed / response;
    }

    private void push(
            int body, int other, double nx, double ny, double lever, double others, double j) {
        double[] m = motions.data;
        m[body + Motions.VX] += m[body + Motions.INVERSE_MASS] * j * nx;
        m[body + Motions.VY] += m[body + Motions.INVERSE_MASS] * j * ny;
        m[body + Motions.SPIN] += m[body + Motions.INVERSE_INERTIA] * j * lever;
        m[other + Motions.VX] -= m[other + Motions.INVERSE_MASS] * j * nx;
        m[other + Motions.VY] -= m[other + Motions.INVERSE_MASS] * j * ny;
        m[other + Motions.SPIN] -= m[other + Motions.INVERSE_INERTIA] * j * others;
    }
}

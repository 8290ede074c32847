package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

import java.util.Arrays;

/**
 * The single rows of the packed contacts, laid out flat in the order of elimination: row {@code
 * 4·place + kind}, where kind is the point of a normal row, {@link #TANGENT} or {@link #ROLL}.
 * Elimination reads each row many times, while {@link PackedContacts} is laid out for passes.
 *
 * <p>A rolling row is the difference of both spins times the contact's width, so that its speed and
 * impulse have the units of all others.
 */
final class FlatRows {

    static final int TANGENT = 2;
    static final int ROLL = 3;
    static final int KINDS = 4;

    /** Unknowns of a hub: its velocity along x and y, and its spin. */
    static final int AXES = 3;

    /**
     * Compliance added to the rows of a calm island, as a share of their effective inverse masses.
     * It counts from the present impulses, so that rounds take its error away (the proximal point
     * method: R. T. Rockafellar, "Monotone operators and the proximal point algorithm", 1976).
     * Redundant contacts then keep the shares of a load that they have. With the compliance of
     * {@link PackedContacts} alone, round-off would choose the seventh digit of them.
     */
    private static final double PROXIMAL = 1e-7;

    private final Motions motions;
    private final PackedContacts contacts;
    private final ContactOrder order;

    /** By row: the offsets of its bodies in the motions. */
    private int[] bodyA = new int[0];

    private int[] bodyB = new int[0];

    /** By row: its direction, and its levers in m. */
    private double[] directionX = new double[0];

    private double[] directionY = new double[0];
    private double[] leverA = new double[0];
    private double[] leverB = new double[0];

    /** By row: its compliance, the speed at which it yields to a unit impulse, 1/kg. */
    double[] give = new double[0];

    /** By row: speed that its own unit impulse gives it, without its compliance, 1/kg. */
    double[] answer = new double[0];

    /** By row: the speed that it aims at, m/s. */
    private double[] target = new double[0];

    /** By row: its impulse, and the impulse from which its compliance counts, N·s. */
    double[] impulse = new double[0];

    double[] kept = new double[0];

    /**
     * By row: s times its share of the load, if its impulse goes with the load in the direction s =
     * ±1, as that of sliding friction does; otherwise 0.
     */
    private double[] following = new double[0];

    FlatRows(Motions motions, PackedContacts contacts, ContactOrder order) {
        this.motions = motions;
        this.contacts = contacts;
        this.order = order;
    }

    /**
     * Lays out the parts that a substep does not change: derivatives and compliances.
     *
     * @param isNearby whether the impulses nearest to the present ones are to be found
     */
    void layOut(boolean isNearby) {
        reserve();
        for (int place = 0; place < contacts.count; place++) {
            int row = order.order[place];
            int at = row * PackedContacts.STRIDE;
            double[] d = contacts.data;
            double nx = d[at + PackedContacts.NX];
            double ny = d[at + PackedContacts.NY];
            double giveOfPoint = d[at + PackedContacts.GIVE];
            int k = KINDS * place;
            layOut(k, row, nx, ny, at + PackedContacts.LEVER_A0);
            give[k] = giveOfPoint;
            layOut(k + 1, row, nx, ny, at + PackedContacts.LEVER_A1);
            give[k + 1] = giveOfPoint;
            layOut(k + TANGENT, row, -ny, nx, at + PackedContacts.LEVER_TA);
            give[k + TANGENT] = PackedContacts.COMPLIANCE / d[at + PackedContacts.MASS_T];
            boolean rolls = d[at + PackedContacts.ROLLING] > 0;
            if (rolls) {
                double width = d[at + PackedContacts.WIDTH];
                layOut(k + ROLL, row, 0, 0, width, width);
                give[k + ROLL] = PackedContacts.COMPLIANCE * answer[k + ROLL];
            }
            for (int i = k; isNearby && i <= k + (rolls ? ROLL : TANGENT); i++) {
                give[i] += PROXIMAL * answer[i];
            }
        }
    }

    private void layOut(int k, int row, double x, double y, int levers) {
        layOut(k, row, x, y, contacts.data[levers], contacts.data[levers + 1]);
    }

    private void layOut(int k, int row, double x, double y, double ofA, double ofB) {
        bodyA[k] = contacts.bodyA[row];
        bodyB[k] = contacts.bodyB[row];
        directionX[k] = x;
        directionY[k] = y;
        leverA[k] = ofA;
        leverB[k] = ofB;
        answer[k] = response(k, k, true);
    }

    private void reserve() {
        if (bodyA.length < KINDS * contacts.count) {
            int capacity = KINDS * contacts.pair.length;
            bodyA = new int[capacity];
            bodyB = new int[capacity];
            directionX = new double[capacity];
            directionY = new double[capacity];
            leverA = new double[capacity];
            leverB = new double[capacity];
            give = new double[capacity];
            answer = new double[capacity];
            target = new double[capacity];
            impulse = new double[capacity];
            kept = new double[capacity];
            following = new double[capacity];
        }
    }

    /** Reads the impulses, and the speeds that rows aim at in a substep of h seconds. */
    void read(double h) {
        for (int place = 0; place < contacts.count; place++) {
            int row = order.order[place];
            int at = row * PackedContacts.STRIDE;
            double[] d = contacts.data;
            double nearing = d[at + PackedContacts.NEARING];
            int k = KINDS * place;
            for (int point = 0; point < contacts.points[row]; point++) {
                double gap = motions.gap(contacts, row, point);
                target[k + point] = nearing - (gap > 0 ? gap / h : 0);
                impulse[k + point] = d[at + PackedContacts.IMPULSE0 + point];
            }
            target[k + TANGENT] = contacts.surface[row];
            impulse[k + TANGENT] = d[at + PackedContacts.IMPULSE_T];
            impulse[k + ROLL] =
                    d[at + PackedContacts.ROLLING] > 0
                            ? d[at + PackedContacts.IMPULSE_R] / d[at + PackedContacts.WIDTH]
                            : 0;
        }
    }

    /** Writes the impulses back. */
    void write() {
        for (int place = 0; place < contacts.count; place++) {
            int row = order.order[place];
            int at = row * PackedContacts.STRIDE;
            double[] d = contacts.data;
            int k = KINDS * place;
            for (int point = 0; point < contacts.points[row]; point++) {
                d[at + PackedContacts.IMPULSE0 + point] = impulse[k + point];
            }
            d[at + PackedContacts.IMPULSE_T] = impulse[k + TANGENT];
            if (d[at + PackedContacts.ROLLING] > 0) {
                d[at + PackedContacts.IMPULSE_R] = impulse[k + ROLL] * d[at + PackedContacts.WIDTH];
            }
        }
    }

    /** Whether a row is that of a point, whose impulse is a part of the load. */
    static boolean isPoint(int k) {
        return k % KINDS < TANGENT;
    }

    /**
     * Share of a contact's load that bounds a tangent or rolling row: μ, or the rolling lever as a
     * share of the width.
     */
    double share(int k) {
        int at = order.order[k / KINDS] * PackedContacts.STRIDE;
        return k % KINDS == TANGENT
                ? contacts.data[at + PackedContacts.FRICTION]
                : contacts.data[at + PackedContacts.ROLLING]
                        / contacts.data[at + PackedContacts.WIDTH];
    }

    /** Residual of a row: its speed minus the one it aims at, m/s. */
    double approach(int k) {
        double[] m = motions.data;
        int a = bodyA[k];
        int b = bodyB[k];
        double speed =
                directionX[k] * (m[b + Motions.VX] - m[a + Motions.VX])
                        + directionY[k] * (m[b + Motions.VY] - m[a + Motions.VY])
                        + leverB[k] * m[b + Motions.SPIN]
                        - leverA[k] * m[a + Motions.SPIN];
        return speed + give[k] * (impulse[k] - kept[k]) - target[k];
    }

    /** Largest residual of the rows of a set, m/s. */
    double worst(int[] set, int size) {
        double worst = 0;
        for (int i = 0; i < size; i++) {
            worst = Math.max(worst, Math.abs(approach(set[i])));
        }
        return worst;
    }

    /** The impulse that would solve a row alone, N·s. */
    double wanted(int k) {
        return impulse[k] - approach(k) / (answer[k] + give[k]);
    }

    /** Speed that the impulse which solves a row alone would give it, m/s. */
    double answerAfterOwnChange(int k) {
        return answer[k] * wanted(k);
    }

    /** Changes a row's impulse by an amount in N·s, and the velocities of its bodies with it. */
    void push(int k, double change) {
        impulse[k] += change;
        apply(k, change, Motions.VX);
    }

    /** Sets a row's impulse, N·s, and changes the velocities of its bodies. */
    void set(int k, double value) {
        if (impulse[k] != value) {
            push(k, value - impulse[k]);
            impulse[k] = value;
        }
    }

    /** Displaces the bodies of a row, as an impulse would move them in one second, kg·m. */
    void move(int k, double push) {
        apply(k, push, Motions.DX);
    }

    /** Changes three adjacent columns, x, y and turn, by an impulse. */
    private void apply(int k, double change, int column) {
        double[] m = motions.data;
        int a = bodyA[k];
        int b = bodyB[k];
        double ma = m[a + Motions.INVERSE_MASS] * change;
        double mb = m[b + Motions.INVERSE_MASS] * change;
        m[a + column] -= ma * directionX[k];
        m[a + column + 1] -= ma * directionY[k];
        m[a + column + 2] -= m[a + Motions.INVERSE_INERTIA] * leverA[k] * change;
        m[b + column] += mb * directionX[k];
        m[b + column + 1] += mb * directionY[k];
        m[b + column + 2] += m[b + Motions.INVERSE_INERTIA] * leverB[k] * change;
    }

    /** Lets no row go with the load of its contact. */
    void followNone() {
        Arrays.fill(following, 0, KINDS * contacts.count, 0);
    }

    /** Lets a tangent or rolling row go with the load, by a share of it. */
    void follow(int k, double share) {
        following[k] = share;
    }

    /** The impulse of a kind that comes with a unit impulse of a point; 0 if it does not. */
    double following(int point, int kind) {
        return isPoint(point) ? following[of(point, kind)] : 0;
    }

    /** Changes a point's impulse by an amount in N·s, with what goes with it. */
    void pushWithFollowing(int point, double change) {
        push(point, change);
        for (int kind = TANGENT; kind < KINDS; kind++) {
            double follows = following(point, kind);
            if (follows != 0) {
                push(of(point, kind), follows * change);
            }
        }
    }

    /** The row of a kind of the same contact. */
    private static int of(int k, int kind) {
        return k - k % KINDS + kind;
    }

    /**
     * Speed that a unit impulse of one row, with what goes with it, gives another through bodies
     * that are not hubs, 1/kg.
     */
    double answerTo(int i, int j) {
        double answer = response(i, j, false);
        for (int kind = TANGENT; kind < KINDS; kind++) {
            double follows = following(j, kind);
            if (follows != 0) {
                answer += follows * response(i, of(j, kind), false);
            }
        }
        return answer;
    }

    /**
     * The speed that a hub's velocity along an axis, over the square root of the inverse mass
     * there, gives a row, 1/√kg; and so the impulse on the hub from a unit impulse of the row.
     */
    double ofHub(int k, int hub, int axis) {
        double sum = 0;
        if (bodyB[k] == hub) {
            sum += axis == 0 ? directionX[k] : axis == 1 ? directionY[k] : leverB[k];
        }
        if (bodyA[k] == hub) {
            sum -= axis == 0 ? directionX[k] : axis == 1 ? directionY[k] : leverA[k];
        }
        int column = axis < 2 ? Motions.INVERSE_MASS : Motions.INVERSE_INERTIA;
        return sum == 0 ? 0 : sum * Math.sqrt(motions.data[hub + column]);
    }

    /** The impulse that a unit impulse of a row, with what goes with it, brings to a hub, 1/√kg. */
    double toHub(int k, int hub, int axis) {
        double brings = ofHub(k, hub, axis);
        for (int kind = TANGENT; kind < KINDS; kind++) {
            double follows = following(k, kind);
            if (follows != 0) {
                brings += follows * ofHub(of(k, kind), hub, axis);
            }
        }
        return brings;
    }

    /** Speed that a unit impulse of one row gives another, through hubs or not, 1/kg. */
    private double response(int i, int j, boolean throughHubs) {
        double direct = directionX[i] * directionX[j] + directionY[i] * directionY[j];
        int a = bodyA[i];
        int b = bodyB[i];
        double sum = 0;
        if (throughHubs || !order.isHub(a)) {
            sum += a == bodyA[j] ? through(a, direct, leverA[i] * leverA[j]) : 0;
            sum -= a == bodyB[j] ? through(a, direct, leverA[i] * leverB[j]) : 0;
        }
        if (throughHubs || !order.isHub(b)) {
            sum += b == bodyB[j] ? through(b, direct, leverB[i] * leverB[j]) : 0;
            sum -= b == bodyA[j] ? through(b, direct, leverB[i] * leverA[j]) : 0;
        }
        return sum;
    }

    /** Response through a shared body; the ground, offset 0, passes nothing on. */
    private double through(int body, double direct, double levers) {
        double[] m = motions.data;
        return m[body + Motions.INVERSE_MASS] * direct + m[body + Motions.INVERSE_INERTIA] * levers;
    }
}

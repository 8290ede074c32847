package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.PointSpeeds;

/** Builds the packed contacts of an island from its pairs. */
public final class RowBuilder {

    /**
     * Relative determinant below which two points count as one, since their mass matrix would be
     * too ill-conditioned.
     */
    private static final double DEPENDENT = 1e-4;

    /** Overlap above which a contact is crushed, in widths of the smaller body. */
    private static final double CRUSHED = 0.05;

    /**
     * Overlap above which a driven body presses no further in a crowd, in widths; a hard impact
     * there presses bodies deeper than {@link #CRUSHED} for a moment.
     */
    private static final double HALTS_IN_A_CROWD = 0.25;

    /** Closing speed, as a share of the pressing speed, above which a driven body is halted. */
    private static final double STAYS_BEHIND = 0.5;

    /** Offset of the ground in the motions. */
    private static final int GROUND = 0;

    /**
     * Compliance of contacts with driven bodies, as a share of the speed that an impulse gives the
     * whole island: such a contact yields at 1 % of g·h under the island's weight. A driven body
     * presses with any force, and against a wall no force would be enough, so that without
     * compliance the equations would squeeze a body out at any speed.
     */
    private static final double GIVE_OF_DRIVEN = 0.01;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;
    private final Colours colours;
    private final Motions motions;
    private final PackedContacts contacts;

    /** Turning of the packed bodies; null without rotation. */
    private final PackedTurns turns;

    /** Mass of all movable bodies of the packed island, kg. */
    private double mass;

    /** Overlap above which a driven body presses no further in this island, in widths. */
    private double halts;

    public RowBuilder(
            DataStorage data, Motions motions, PackedContacts contacts, PackedTurns turns) {
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
        this.motions = motions;
        this.contacts = contacts;
        this.turns = turns;
        colours = new Colours(data);
    }

    /** Packs an island whose first kick has a length of {@code firstKick} seconds. */
    public void build(int island, double firstKick) {
        packBodies(island);
        int driven = motions.count;
        mass = motions.mass();
        int bodyCount = islands.bodyStart[island + 1] - islands.bodyStart[island];
        halts = PackedContacts.areCrowd(islands, island) ? HALTS_IN_A_CROWD : CRUSHED;
        contacts.clear(bodyCount);
        colours.find(island);
        for (int colour = 0; colour < colours.count; colour++) {
            for (int i = contacts.count; i < colours.end[colour]; i++) {
                addRow(colours.order[i], firstKick);
            }
            contacts.endColour();
        }
        contacts.groundStart = colours.groundStart;
        contacts.groundColour = colours.groundColour;
        if (turns != null) {
            turns.pack(driven);
        }
    }

    /** Packs only the bodies of an island. */
    public void packBodies(int island) {
        motions.clear(bodies);
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            motions.offset(bodies, islands.bodies[i]);
        }
        if (turns != null) {
            turns.pack(1);
        }
    }

    /** Offset of a body in the motions; packs it first if it moves and is not packed yet. */
    public int offset(int slot) {
        int before = motions.count;
        int offset = motions.offset(bodies, slot);
        if (turns != null && motions.count > before) {
            turns.pack(before);
        }
        return offset;
    }

    private void addRow(int pair, double firstKick) {
        int row = contacts.add();
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        contacts.pair[row] = pair;
        contacts.points[row] = Math.max(1, pairs.points[pair]);
        boolean isHalted = isPressedInVain(pair);
        boolean crushes = isCrushed(bodies, pairs, pair, pairs.gap(pair));
        contacts.bodyA[row] = isHalted && bodies.isDriven(a) ? GROUND : motions.offset(bodies, a);
        contacts.bodyB[row] = isHalted && bodies.isDriven(b) ? GROUND : motions.offset(bodies, b);
        pairs.crushed[pair] = crushes;
        contacts.isAnyCrushed |= crushes;
        int at = row * PackedContacts.STRIDE;
        writeManifold(row, at, pair);
        if (pairs.points[pair] == 0) {
            contacts.data[at + PackedContacts.GAP0] = PackedContacts.OUT_OF_REACH;
        }
        contacts.data[at + PackedContacts.RECOVERY] = Recovery.RATE;
        contacts.data[at + PackedContacts.WIDTH] = PairTolerances.width(bodies, a, b);
        writeImpulses(row, at, pair, firstKick);
    }

    /** Warm starts from the stored forces; a contact of one row gets the load of both points. */
    private void writeImpulses(int row, int at, int pair, double firstKick) {
        double[] d = contacts.data;
        double impulse0 = pairs.normalForce[2 * pair] * firstKick;
        double impulse1 = pairs.normalForce[2 * pair + 1] * firstKick;
        double load0 = pairs.load[2 * pair];
        double load1 = pairs.load[2 * pair + 1];
        boolean isPair = contacts.points[row] == 2;
        d[at + PackedContacts.LOAD0] = isPair ? load0 : load0 + load1;
        d[at + PackedContacts.LOAD1] = isPair ? load1 : 0;
        d[at + PackedContacts.IMPULSE0] = isPair ? impulse0 : impulse0 + impulse1;
        d[at + PackedContacts.IMPULSE1] = isPair ? impulse1 : 0;
    }

    /**
     * Writes a contact again whose manifold was measured at the present poses. Its gaps are
     * converted to those at which the bodies entered the pile, since displacements count from
     * there.
     */
    void rewrite(int row) {
        int pair = contacts.pair[row];
        int at = row * PackedContacts.STRIDE;
        double[] d = contacts.data;
        contacts.points[row] = Math.max(1, pairs.points[pair]);
        writeManifold(row, at, pair);
        d[at + PackedContacts.GAP0] =
                2 * d[at + PackedContacts.GAP0] - motions.gap(contacts, row, 0);
        d[at + PackedContacts.GAP1] =
                2 * d[at + PackedContacts.GAP1] - motions.gap(contacts, row, 1);
        if (pairs.points[pair] == 0) {
            d[at + PackedContacts.GAP0] = PackedContacts.OUT_OF_REACH;
        }
        if (contacts.points[row] < pairs.points[pair]) {
            carryAtOne(at);
        }
    }

    /** Gives the first point both impulses, since no row could take back that of the second. */
    private void carryAtOne(int at) {
        double[] d = contacts.data;
        d[at + PackedContacts.LOAD0] += d[at + PackedContacts.LOAD1];
        d[at + PackedContacts.LOAD1] = 0;
        d[at + PackedContacts.IMPULSE0] += d[at + PackedContacts.IMPULSE1];
        d[at + PackedContacts.IMPULSE1] = 0;
        d[at + PackedContacts.BEFORE0] += d[at + PackedContacts.BEFORE1];
        d[at + PackedContacts.BEFORE1] = 0;
    }

    private void writeManifold(int row, int at, int pair) {
        if (turns != null) {
            writeLevers(row, at, pair);
            writeNormalMasses(row, at);
        } else {
            writeStraight(row, at, pair);
        }
    }

    /** Without rotation levers are zero, and the nearer of two points is enough. */
    private void writeStraight(int row, int at, int pair) {
        double[] d = contacts.data;
        d[at + PackedContacts.NX] = pairs.normalX[pair];
        d[at + PackedContacts.NY] = pairs.normalY[pair];
        d[at + PackedContacts.GAP0] = pairs.gap(pair);
        contacts.points[row] = 1;
        writeMass(row, at, response(row, 0, 0, 0, 0));
        d[at + PackedContacts.M00] = 1 / d[at + PackedContacts.K00];
    }

    private void writeLevers(int row, int at, int pair) {
        double[] d = contacts.data;
        double nx = pairs.normalX[pair];
        double ny = pairs.normalY[pair];
        double ax = centreX(pairs.bodyA[pair], contacts.bodyA[row]);
        double ay = centreY(pairs.bodyA[pair], contacts.bodyA[row]);
        double bx = centreX(pairs.bodyB[pair], contacts.bodyB[row]);
        double by = centreY(pairs.bodyB[pair], contacts.bodyB[row]);
        for (int i = 0; i < pairs.points[pair]; i++) {
            double px = pairs.pointX[2 * pair + i];
            double py = pairs.pointY[2 * pair + i];
            int shift = at + 2 * i;
            d[shift + PackedContacts.LEVER_A0] = (px - ax) * ny - (py - ay) * nx;
            d[shift + PackedContacts.LEVER_B0] = (px - bx) * ny - (py - by) * nx;
            d[at + PackedContacts.GAP0 + i] = pairs.separation[2 * pair + i];
        }
        d[at + PackedContacts.NX] = nx;
        d[at + PackedContacts.NY] = ny;
        double rubsAt = rubsAt(pairs, pair, nx, ny);
        d[at + PackedContacts.LEVER_TA] = rubsAt - ax * nx - ay * ny;
        d[at + PackedContacts.LEVER_TB] = rubsAt - bx * nx - by * ny;
    }

    /**
     * Position of friction along the normal, m: that of the nearest point, so that a body that
     * stands on one corner turns about it.
     */
    public static double rubsAt(Pairs pairs, int pair, double nx, double ny) {
        int point = 2 * pair;
        double first = nx * pairs.pointX[point] + ny * pairs.pointY[point];
        if (pairs.points[pair] < 2) {
            return first;
        }
        double second = nx * pairs.pointX[point + 1] + ny * pairs.pointY[point + 1];
        double difference = pairs.separation[point + 1] - pairs.separation[point];
        return difference == 0 ? (first + second) / 2 : difference > 0 ? first : second;
    }

    private double centreX(int slot, int entry) {
        return bodies.x[slot] + motions.data[entry + Motions.DX];
    }

    private double centreY(int slot, int entry) {
        return bodies.y[slot] + motions.data[entry + Motions.DY];
    }

    private void writeNormalMasses(int row, int at) {
        double[] d = contacts.data;
        double k00 =
                response(
                        row,
                        d[at + PackedContacts.LEVER_A0],
                        d[at + PackedContacts.LEVER_B0],
                        d[at + PackedContacts.LEVER_A0],
                        d[at + PackedContacts.LEVER_B0]);
        writeMass(row, at, k00);
        if (contacts.points[row] == 1) {
            d[at + PackedContacts.M00] = 1 / d[at + PackedContacts.K00];
        } else {
            writePairMasses(row, at);
        }
    }

    private void writeMass(int row, int at, double k00) {
        double give = PackedContacts.COMPLIANCE * k00 + (isDriven(row) ? GIVE_OF_DRIVEN / mass : 0);
        contacts.data[at + PackedContacts.GIVE] = give;
        contacts.data[at + PackedContacts.K00] = k00 + give;
    }

    private void writePairMasses(int row, int at) {
        double[] d = contacts.data;
        double k01 =
                response(
                        row,
                        d[at + PackedContacts.LEVER_A0],
                        d[at + PackedContacts.LEVER_B0],
                        d[at + PackedContacts.LEVER_A1],
                        d[at + PackedContacts.LEVER_B1]);
        double k11 =
                response(
                        row,
                        d[at + PackedContacts.LEVER_A1],
                        d[at + PackedContacts.LEVER_B1],
                        d[at + PackedContacts.LEVER_A1],
                        d[at + PackedContacts.LEVER_B1]);
        double k00 = d[at + PackedContacts.K00];
        k11 += d[at + PackedContacts.GIVE];
        d[at + PackedContacts.K01] = k01;
        d[at + PackedContacts.K11] = k11;
        double determinant = k00 * k11 - k01 * k01;
        if (determinant > DEPENDENT * k00 * k11) {
            d[at + PackedContacts.M00] = k11 / determinant;
            d[at + PackedContacts.M01] = -k01 / determinant;
            d[at + PackedContacts.M11] = k00 / determinant;
        } else {
            keepDeeper(row, at);
        }
    }

    private boolean isDriven(int row) {
        int pair = contacts.pair[row];
        return bodies.isDriven(pairs.bodyA[pair]) || bodies.isDriven(pairs.bodyB[pair]);
    }

    /**
     * Whether a driven body presses deep into another body that does not move along with it. The
     * driven body then counts as standing still. A body that moves along was hit hard and has room
     * to go; one that was not pushed before may have.
     */
    private boolean isPressedInVain(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        boolean isDriven = bodies.isDriven(a) || bodies.isDriven(b);
        return isDriven
                && pairs.touchedBefore[pair]
                && -pairs.gap(pair) > halts * PairTolerances.width(bodies, a, b)
                && (staysBehind(pair, 2 * pair)
                        || staysBehind(pair, 2 * pair + pairs.points[pair] - 1));
    }

    /** Whether an overlap crushes, by the width of the smaller body, movable or not. */
    static boolean isCrushed(Bodies bodies, Pairs pairs, int pair, double gap) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double width = Math.min(bodies.smallestWidth[a], bodies.smallestWidth[b]);
        return -gap > CRUSHED * width;
    }

    /** Whether a point closes at more than half of the driven body's pressing speed. */
    private boolean staysBehind(int pair, int point) {
        int a = pairs.bodyA[pair];
        double pressing =
                bodies.isDriven(a)
                        ? PointSpeeds.along(bodies, pairs, pair, point, a)
                        : -PointSpeeds.along(bodies, pairs, pair, point, pairs.bodyB[pair]);
        double parting = PointSpeeds.parting(bodies, pairs, pair, point);
        return pressing > 0 && -parting > STAYS_BEHIND * pressing;
    }

    /** Replaces two dependent points with the deeper one. */
    private void keepDeeper(int row, int at) {
        double[] d = contacts.data;
        contacts.points[row] = 1;
        if (d[at + PackedContacts.GAP1] < d[at + PackedContacts.GAP0]) {
            d[at + PackedContacts.GAP0] = d[at + PackedContacts.GAP1];
            d[at + PackedContacts.LEVER_A0] = d[at + PackedContacts.LEVER_A1];
            d[at + PackedContacts.LEVER_B0] = d[at + PackedContacts.LEVER_B1];
            d[at + PackedContacts.K00] = d[at + PackedContacts.K11];
        }
        d[at + PackedContacts.M00] = 1 / d[at + PackedContacts.K00];
    }

    private double response(int row, double la, double lb, double ma, double mb) {
        return motions.response(contacts.bodyA[row], contacts.bodyB[row], la, lb, ma, mb);
    }
}

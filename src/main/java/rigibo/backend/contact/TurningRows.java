package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.Pose;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.Pairs;

/**
 * The contacts of bodies that turn fast. A row takes the outline of its bodies for straight, and
 * the way they go for straight too; while a body of reach R turns by φ, its outline leaves that
 * line by the sagitta Rφ²/2, and by sφ more where it slides on for s. Where a step's sagitta
 * counts, the contact is measured anew before every substep; where a substep's would, the island is
 * given more of them, and takes back at once what it missed.
 */
final class TurningRows {

    /** What all substeps may miss together, likewise; n of them miss an n-th of the whole way. */
    private static final double CALM = 0.02;

    /** Share of a face that a body may turn by in a substep, at the end of which a corner lands. */
    private static final double MOST_OF_FACE = 0.05;

    /** Bodies of an island up to which that counts: in a heap nothing rolls on by itself. */
    private static final int FEW = 4;

    /** An island is given at most this many times the substeps of a calm one; */
    private static final double MOST_MORE = 16;

    /** no more than this over its number of bodies, for one wild body in a heap costs them all. */
    private static final double MOST_IN_ALL = 1024;

    /** Turn within a substep up to which the arc is that of a parabola, rad. */
    private static final double MOST_BEND = 0.1;

    /** Share of an overlap taken back per second for each such time: all of it, 1/s. */
    private static final double AT_ONCE = 1e4;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;
    private final Narrowphase narrowphase;
    private final Motions motions;
    private final Rows rows;
    private final RowBuilder builder;
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /** Sagitta of a whole step that may be passed over, as a share of the body's width. */
    private final double straight;

    /** How many times the usual substeps the packed island has. */
    private double more;

    TurningRows(
            DataStorage data,
            Narrowphase narrowphase,
            Motions motions,
            Rows rows,
            RowBuilder builder,
            double straight) {
        this.straight = straight;
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
        this.narrowphase = narrowphase;
        this.motions = motions;
        this.rows = rows;
        this.builder = builder;
    }

    /** How many substeps the bodies of an island need for the rest of a step, usually as usual. */
    int substepsFor(int island, double left, int usual) {
        double wanted = 1;
        int end = islands.bodyStart[island + 1];
        for (int i = islands.bodyStart[island]; i < end; i++) {
            int slot = islands.bodies[i];
            double missed = leaves(slot, left) / usual;
            wanted = Math.max(wanted, missed / (CALM * bodies.smallestWidth[slot]));
            if (end - islands.bodyStart[island] <= FEW) {
                wanted = Math.max(wanted, facesTurned(slot, left) / (usual * MOST_OF_FACE));
            }
        }
        double most = Math.min(MOST_MORE, MOST_IN_ALL / (end - islands.bodyStart[island]));
        more = Math.max(1, Math.min(most, wanted));
        return (int) Math.ceil(usual * more);
    }

    /** By how many of its faces a body turns in h seconds: each puts it on another corner. */
    private double facesTurned(int slot, double h) {
        return bodies.shape[slot] instanceof Polygon polygon
                ? Math.abs(bodies.spin[slot]) * h * polygon.corners() / (2 * Math.PI)
                : 0;
    }

    /** How far in m the outline leaves its line in h seconds, by turning and by sliding off it. */
    private double leaves(int slot, double h) {
        double turn = bodies.sweepRadius[slot] > 0 ? Math.abs(bodies.spin[slot]) * h : 0;
        double way = h * (Math.abs(bodies.velocityX[slot]) + Math.abs(bodies.velocityY[slot]));
        return sagitta(slot, turn) + way * turn;
    }

    /**
     * Measures anew what turned too far or is about to, before a substep of h seconds that begins
     * at {@code time}, with {@code left} seconds to go; and what joins the pile in that substep,
     * where the two are when it joins: the pile has moved on since the step's start.
     *
     * @return whether there was anything
     */
    boolean refresh(int substep, double h, double time, double left) {
        boolean turns = isAnyTurning(left);
        boolean isAny = false;
        for (int row = 0; row < rows.count; row++) {
            boolean joins = rows.firstSubstep[row] == substep;
            boolean isTurning =
                    turns && (isTurning(rows.bodyA[row], left) || isTurning(rows.bodyB[row], left));
            if (joins) {
                measureAhead(row, left, Math.max(0, joinsAt(row) - time));
            } else if (isTurning && substep > 0) {
                measure(row, left);
            }
            if (isTurning) {
                bend(row, h);
            } else if (isBent(row)) {
                bend(row, 0);
            }
            isAny |= joins || isTurning;
        }
        return isAny;
    }

    /**
     * A point that turns with its body leaves its line by ½ω²h² of its arm within a substep,
     * towards the centre of mass. So much wider is the gap that may close, and so much the point
     * must run ahead along the surface if it is to stay where it is: then what pivots on a corner
     * keeps its energy but for terms in h². Where the gap gets narrower by itself, the contact has
     * to part as fast.
     */
    private void bend(int row, double h) {
        int at = row * Rows.STRIDE;
        double[] d = rows.data;
        double bendA = bend(pairs.bodyA[rows.pair[row]], rows.bodyA[row], h);
        double bendB = bend(pairs.bodyB[rows.pair[row]], rows.bodyB[row], h);
        double gap =
                bendA * d[at + Rows.LEVER_TA]
                        - bendB * d[at + Rows.LEVER_TB]
                        + faceTurnsAway(row, h);
        double way0 = bendA * d[at + Rows.LEVER_A0] - bendB * d[at + Rows.LEVER_B0];
        double way1 = bendA * d[at + Rows.LEVER_A1] - bendB * d[at + Rows.LEVER_B1];
        double difference = rows.points[row] == 2 ? d[at + Rows.GAP1] - d[at + Rows.GAP0] : 1;
        double way = difference == 0 ? (way0 + way1) / 2 : difference > 0 ? way0 : way1;
        d[at + Rows.GAP0] += Math.max(0, gap);
        d[at + Rows.GAP1] += Math.max(0, gap);
        d[at + Rows.NEARING] = gap < 0 ? -gap / h : 0;
        builder.writeSurface(row, h > 0 ? way / h : 0);
    }

    private boolean isBent(int row) {
        return rows.surface[row] != rows.running[row]
                || rows.data[row * Rows.STRIDE + Rows.NEARING] != 0;
    }

    /** Half the square of the angle by which an outline turns in h seconds. */
    private double bend(int slot, int entry, double h) {
        double turn = turn(slot, entry, h);
        return turn * turn / 2;
    }

    /** The angle by which an outline turns in h seconds, as far as its arc is a parabola's. */
    private double turn(int slot, int entry, double h) {
        double turn = motions.data[entry + Motions.SPIN] * h;
        return bodies.sweepRadius[slot] > 0 ? Math.max(-MOST_BEND, Math.min(MOST_BEND, turn)) : 0;
    }

    /**
     * How much wider than that the gap gets, m, where it is measured from a face that turns while
     * the other body slides along it by s: by φs. Of a disc the point that counts is its centre,
     * which does not go along with the face.
     */
    private double faceTurnsAway(int row, double h) {
        int pair = rows.pair[row];
        int face = pairs.faceOf[pair];
        if (face == Pairs.NONE) {
            return 0;
        }
        boolean isOfA = face == pairs.bodyA[pair];
        double turn = turn(face, isOfA ? rows.bodyA[row] : rows.bodyB[row], h);
        if (turn == 0) {
            return 0;
        }
        double[] d = rows.data;
        int at = row * Rows.STRIDE;
        double armA = d[at + Rows.LEVER_TA];
        double armB = d[at + Rows.LEVER_TB];
        if (bodies.sweepRadius[pairs.other(pair, face)] > 0) {
            return turn * h * slide(row, armA, armB);
        }
        double toCentre = isOfA ? armB : -armA;
        double slide = slide(row, isOfA ? armA : 0, isOfA ? 0 : armB);
        return turn * (h * slide + turn * toCentre / 2);
    }

    /** How fast a point of B slides along one of A, each so far from its body's centre, m/s. */
    private double slide(int row, double armA, double armB) {
        double[] m = motions.data;
        int at = row * Rows.STRIDE;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double nx = rows.data[at + Rows.NX];
        double ny = rows.data[at + Rows.NY];
        return nx * (m[b + Motions.VY] - m[a + Motions.VY])
                - ny * (m[b + Motions.VX] - m[a + Motions.VX])
                + armB * m[b + Motions.SPIN]
                - armA * m[a + Motions.SPIN];
    }

    /** When the later of two bodies joins, s after the step's start. */
    private double joinsAt(int row) {
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double whenA = a == 0 ? 0 : bodies.pileTime[motions.slots[a / Motions.STRIDE]];
        double whenB = b == 0 ? 0 : bodies.pileTime[motions.slots[b / Motions.STRIDE]];
        return Math.max(whenA, whenB);
    }

    private void measureAhead(int row, double left, double ahead) {
        motions.drift(rows.bodyA[row], ahead);
        motions.drift(rows.bodyB[row], ahead);
        measure(row, left);
        motions.drift(rows.bodyA[row], -ahead);
        motions.drift(rows.bodyB[row], -ahead);
    }

    private boolean isAnyTurning(double left) {
        for (int entry = 1; entry < motions.count; entry++) {
            if (isTurning(entry * Motions.STRIDE, left)) {
                return true;
            }
        }
        return false;
    }

    private boolean isTurning(int entry, double left) {
        if (entry == 0) {
            return false;
        }
        int slot = motions.slots[entry / Motions.STRIDE];
        double turn =
                Math.abs(motions.data[entry + Motions.TURN])
                        + Math.abs(motions.data[entry + Motions.SPIN]) * left;
        return sagitta(slot, turn) > straight * bodies.smallestWidth[slot];
    }

    private double sagitta(int slot, double turn) {
        return bodies.sweepRadius[slot] * turn * turn / 2;
    }

    private void measure(int row, double left) {
        int pair = rows.pair[row];
        int at = row * Rows.STRIDE;
        // The manifold hands on what its columns hold from the points it had to those it has.
        pairs.normalForce[2 * pair] = rows.data[at + Rows.IMPULSE0];
        pairs.normalForce[2 * pair + 1] = rows.data[at + Rows.IMPULSE1];
        place(pairs.bodyA[pair], rows.bodyA[row], poseA);
        place(pairs.bodyB[pair], rows.bodyB[row], poseB);
        narrowphase.measureContact(pair, poseA, poseB, reach(row, pair, left));
        rows.data[at + Rows.IMPULSE0] = pairs.normalForce[2 * pair];
        rows.data[at + Rows.IMPULSE1] = pairs.normalForce[2 * pair + 1];
        double before0 = before(at, pairs.former[2 * pair]);
        double before1 = before(at, pairs.former[2 * pair + 1]);
        rows.data[at + Rows.BEFORE0] = before0;
        rows.data[at + Rows.BEFORE1] = before1;
        builder.rewrite(row);
        rows.data[at + Rows.RECOVERY] = OverlapSolver.RATE + (more - 1) * AT_ONCE;
    }

    private double before(int at, int point) {
        return point == Pairs.NONE ? 0 : rows.data[at + Rows.BEFORE0 + point];
    }

    private void place(int slot, int entry, Pose pose) {
        double angle = bodies.angle[slot] + motions.data[entry + Motions.TURN];
        pose.set(
                bodies.x[slot] + motions.data[entry + Motions.DX],
                bodies.y[slot] + motions.data[entry + Motions.DY],
                Angle.cos(angle),
                Angle.sin(angle));
    }

    /** The gap in m that could close in what is left of the step. */
    private double reach(int row, int pair, double left) {
        double[] m = motions.data;
        int a = rows.bodyA[row];
        int b = rows.bodyB[row];
        double speed =
                Math.abs(m[b + Motions.VX] - m[a + Motions.VX])
                        + Math.abs(m[b + Motions.VY] - m[a + Motions.VY])
                        + Math.abs(m[a + Motions.SPIN]) * bodies.sweepRadius[pairs.bodyA[pair]]
                        + Math.abs(m[b + Motions.SPIN]) * bodies.sweepRadius[pairs.bodyB[pair]];
        return 2 * speed * left + bodies.smallestWidth[pairs.bodyA[pair]];
    }
}

package rigibo.backend.contact.row;

import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Contacts whose normal turns along the way of their bodies: of a disc round another disc or a
 * corner, and, where bodies are few, of whatever slides from one face to the next. They are
 * measured anew before every substep. Round an outline of radius ρ a way of s opens the gap by √(ρ²
 * + s²) − ρ meanwhile, which the gap foresees: so a disc follows a curve as a constrained motion
 * does whose error is of second order (SHAKE: Ryckaert, Ciccotti and Berendsen, 1977).
 */
public final class CurvedRows {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Motions motions;
    private final PackedContacts contacts;

    /** Deviation from a straight line that may be neglected in a step, as a share of the width. */
    private final Straightness straight;

    /** Where the two ends of a face lie along the tangent of a contact, from its body, m. */
    private final double[] endsA = new double[2];

    private final double[] endsB = new double[2];

    public CurvedRows(
            DataStorage data, Motions motions, PackedContacts contacts, Straightness straight) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.motions = motions;
        this.contacts = contacts;
        this.straight = straight;
    }

    /** Whether a contact's normal turns in the step, of which {@code left} seconds are to go. */
    boolean isCurved(int row, double left) {
        int pair = contacts.pair[row];
        double way = Math.abs(slid(row)) + Math.abs(slide(row)) * left;
        double shows =
                straight.unseen()
                        * contacts.data[row * PackedContacts.STRIDE + PackedContacts.WIDTH];
        if (!(way > shows)) {
            return false;
        }
        if (pairs.faceOf[pair] != Pairs.NONE) {
            return motions.areFew() && leavesFace(row, pair, way);
        }
        double radius = radius(pair);
        return (radius > 0 || motions.areFew()) && opens(radius, way) > shows;
    }

    /**
     * Widens the gap by what the motion of the next h seconds opens. Two corners would be given all
     * of that motion, and would overlap where friction stops them, so they are left out.
     */
    void bend(int row, double h) {
        int pair = contacts.pair[row];
        double radius = radius(pair);
        if (radius > 0 && pairs.faceOf[pair] == Pairs.NONE) {
            double opens = opens(radius, slide(row) * h);
            contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP0] += opens;
            contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP1] += opens;
        }
    }

    /**
     * How long a touching face can have no second point, s. A corner that has just come over the
     * end of a face is all that lies on it; the next one may land before anything else does, when
     * the shorter of the two faces is over the other one.
     */
    double untilNewPoint(int row) {
        int pair = contacts.pair[row];
        double width = contacts.data[row * PackedContacts.STRIDE + PackedContacts.WIDTH];
        boolean mayGainPoint =
                pairs.faceOf[pair] != Pairs.NONE
                        && contacts.points[row] == 1
                        && motions.gap(contacts, row) <= PairTolerances.TOUCHING_GAP * width;
        return mayGainPoint ? untilOver(row, pair) : Double.POSITIVE_INFINITY;
    }

    /** How long until half of a face is over another that it has just come to; ∞ if it leaves. */
    private double untilOver(int row, int pair) {
        double apart = findFaces(pair) + slid(row);
        double slide = slide(row);
        double lengthA = Math.abs(endsA[1] - endsA[0]);
        double lengthB = Math.abs(endsB[1] - endsB[0]);
        double from = (endsB[0] + endsB[1] - endsA[0] - endsA[1]) / 2 + apart;
        double shared = (lengthA + lengthB) / 2 - Math.abs(from);
        double half = Math.min(lengthA, lengthB) / 2;
        boolean isNew = from * slide < 0 && shared < half;
        return isNew && half > 0 ? half / Math.abs(slide) : Double.POSITIVE_INFINITY;
    }

    private static double opens(double radius, double way) {
        return Math.sqrt(radius * radius + way * way) - radius;
    }

    /** The radius in m at which two outlines go round each other; a corner has none. */
    private double radius(int pair) {
        return bodies.outline[pairs.shapeA(pair)].radius()
                + bodies.outline[pairs.shapeB(pair)].radius();
    }

    /** Whether a corner, or the foot of a disc, comes to the end of the face it is on. */
    private boolean leavesFace(int row, int pair, double way) {
        double apart = findFaces(pair);
        for (int i = 0; i < 2; i++) {
            for (int j = 0; j < 2; j++) {
                if (Math.abs(endsB[j] + apart - endsA[i]) <= way) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * Finds the ends of the two faces that look at each other; returns how far B lay along the
     * tangent from A when the step began, m.
     */
    private double findFaces(int pair) {
        double nx = pairs.normalX[pair];
        double ny = pairs.normalY[pair];
        findEnds(pair, pairs.bodyA[pair], nx, ny, -1, endsA);
        findEnds(pair, pairs.bodyB[pair], -nx, -ny, 1, endsB);
        return along(pair, nx, ny);
    }

    /** How far B lies along the tangent from A, m. */
    private double along(int pair, double nx, double ny) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        return nx * (bodies.y[b] - bodies.y[a]) - ny * (bodies.x[b] - bodies.x[a]);
    }

    /** Finds the ends of the face that looks along (nx, ny); a disc has but its centre. */
    private void findEnds(int pair, int slot, double nx, double ny, int side, double[] ends) {
        ends[0] = 0;
        ends[1] = 0;
        Outline polygon = bodies.outline[pairs.shapeOf(pair, slot)];
        if (polygon.isCentredDisc()) {
            return;
        }
        double cos = bodies.cos[slot];
        double sin = bodies.sin[slot];
        double x = cos * nx + sin * ny;
        double y = cos * ny - sin * nx;
        int face = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < polygon.edges(); i++) {
            double faces = polygon.normalX(i) * x + polygon.normalY(i) * y;
            if (faces > most) {
                most = faces;
                face = i;
            }
        }
        int next = face + 1 == polygon.corners() ? 0 : face + 1;
        // The tangent of the contact is that of A's outward normal.
        double tx = side * y;
        double ty = -side * x;
        ends[0] = tx * polygon.cornerX(face) + ty * polygon.cornerY(face);
        ends[1] = tx * polygon.cornerX(next) + ty * polygon.cornerY(next);
        if (polygon.isEdge() && face == 0) {
            // Where a chain goes on in a line, so does the face.
            double sign = Math.signum(ends[1] - ends[0]);
            ends[0] -= sign * polygon.before().straight();
            ends[1] += sign * polygon.after().straight();
        }
    }

    /** How far B has slid along A since the step began, m. */
    private double slid(int row) {
        return motions.slid(contacts, row, arm(row, true), arm(row, false));
    }

    /** How fast it does, m/s. */
    private double slide(int row) {
        return motions.slide(contacts, row, arm(row, true), arm(row, false));
    }

    /**
     * Lever of the tangent at the corner of an outline's core, m; 0 for a disc. A round corner
     * turns about that of its core without any change at the contact.
     */
    private double arm(int row, boolean isOfA) {
        int pair = contacts.pair[row];
        Outline outline = bodies.outline[isOfA ? pairs.shapeA(pair) : pairs.shapeB(pair)];
        int at = row * PackedContacts.STRIDE;
        if (outline.isCentredDisc()) {
            return 0;
        }
        return isOfA
                ? contacts.data[at + PackedContacts.LEVER_TA] + outline.radius()
                : contacts.data[at + PackedContacts.LEVER_TB] - outline.radius();
    }
}

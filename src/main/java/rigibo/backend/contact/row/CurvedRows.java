package rigibo.backend.contact.row;

import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Contacts whose normal turns as their bodies move: a disc moving around another disc or a corner,
 * and, in islands of few bodies, any body that slides from one face to the next. They are measured
 * again before every substep. In a substep, motion by s around a radius ρ opens the gap by √(ρ² +
 * s²) − ρ, which is added to the gap beforehand. A disc thus follows a curve with an error of
 * second order, as in constrained dynamics (SHAKE: Ryckaert, Ciccotti and Berendsen, 1977).
 */
public final class CurvedRows {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Motions motions;
    private final PackedContacts contacts;

    /** Deviation from a straight line that is neglected in a step, in widths. */
    private final Straightness straight;

    /** Ends of A's face along the tangent of a contact, from A's centre of mass, m. */
    private final double[] endsA = new double[2];

    /** Ends of B's face along the tangent of a contact, from B's centre of mass, m. */
    private final double[] endsB = new double[2];

    public CurvedRows(
            DataStorage data, Motions motions, PackedContacts contacts, Straightness straight) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.motions = motions;
        this.contacts = contacts;
        this.straight = straight;
    }

    /** Whether a contact's normal turns in the step, of which {@code left} seconds remain. */
    boolean isCurved(int row, double left) {
        int pair = contacts.pair[row];
        boolean isFace = pairs.faceOf[pair] != Pairs.NONE;
        double radius = isFace ? 0 : radius(pair);
        if (radius == 0 && !motions.areFew()) {
            return false;
        }
        double way = Math.abs(slid(row)) + Math.abs(slide(row)) * left;
        double shows = straight.unseen() * contacts.width(row);
        return way > shows && (isFace ? leavesFace(pair, way) : opens(radius, way) > shows);
    }

    /**
     * Widens the gap by what the motion of the next h seconds opens. Contacts of two corners are
     * left out: their gap would be widened by all of that motion, and they would overlap where
     * friction stops it.
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
     * Time for which a touching face has no second point, s. A corner that has just come over the
     * end of a face is the only point on it; the next one may land once the shorter of the two
     * faces lies over the other one.
     */
    double untilNewPoint(int row) {
        int pair = contacts.pair[row];
        double width = contacts.width(row);
        boolean mayGainPoint =
                pairs.faceOf[pair] != Pairs.NONE
                        && contacts.points[row] == 1
                        && motions.gap(contacts, row) <= PairTolerances.TOUCHING_GAP * width;
        return mayGainPoint ? untilOver(row, pair) : Double.POSITIVE_INFINITY;
    }

    /** Time until half of a face is over another that it has just reached, s; ∞ if it leaves. */
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

    /** Radius at which two outlines move around each other, m; 0 for corners. */
    private double radius(int pair) {
        return bodies.outline[pairs.shapeA(pair)].radius()
                + bodies.outline[pairs.shapeB(pair)].radius();
    }

    /** Whether a corner, or the lowest point of a disc, reaches the end of the face it is on. */
    private boolean leavesFace(int pair, double way) {
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
     * Finds the ends of two opposite faces; returns the position of B relative to A along the
     * tangent when the step began, m.
     */
    private double findFaces(int pair) {
        double nx = pairs.normalX[pair];
        double ny = pairs.normalY[pair];
        findEnds(pair, pairs.bodyA[pair], nx, ny, -1, endsA);
        findEnds(pair, pairs.bodyB[pair], -nx, -ny, 1, endsB);
        return along(pair, nx, ny);
    }

    /** Position of B relative to A along the tangent, m. */
    private double along(int pair, double nx, double ny) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        return nx * (bodies.y[b] - bodies.y[a]) - ny * (bodies.x[b] - bodies.x[a]);
    }

    /** Finds the ends of the face with the normal (nx, ny); for a disc both are its centre. */
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
            // If the next edge of a chain is collinear, the face extends over it.
            double sign = Math.signum(ends[1] - ends[0]);
            ends[0] -= sign * polygon.before().straight();
            ends[1] += sign * polygon.after().straight();
        }
    }

    /** Distance that B has slid along A since the step began, m. */
    private double slid(int row) {
        return motions.slid(contacts, row, arm(row, true), arm(row, false));
    }

    /** Speed at which B slides along A, m/s. */
    private double slide(int row) {
        return motions.slide(contacts, row, arm(row, true), arm(row, false));
    }

    /**
     * Lever of the tangent, m, at the corner of an outline's core, which lies a radius inside of
     * the outline: a rounded shape that turns about that corner changes nothing at the contact. It
     * is 0 for a disc. For a face it is where that corner of the other shape is, a radius outside,
     * since the corner stays in place on the face if it turns with it.
     */
    private double arm(int row, boolean isOfA) {
        int pair = contacts.pair[row];
        Outline ofA = bodies.outline[pairs.shapeA(pair)];
        Outline ofB = bodies.outline[pairs.shapeB(pair)];
        Outline outline = isOfA ? ofA : ofB;
        if (outline.isCentredDisc()) {
            return 0;
        }
        boolean isFace = pairs.faceOf[pair] == (isOfA ? pairs.bodyA[pair] : pairs.bodyB[pair]);
        double inside = isFace ? -(isOfA ? ofB : ofA).radius() : outline.radius();
        int at = row * PackedContacts.STRIDE;
        return isOfA
                ? contacts.data[at + PackedContacts.LEVER_TA] - inside
                : contacts.data[at + PackedContacts.LEVER_TB] + inside;
    }
}

package rigibo.backend.force;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.ShapeKind;

/**
 * The submerged part of a body under a level: area, centroid and second moment, exactly. Mutable,
 * so that its owner reuses it. Positions are relative to the body's centre of mass, along the
 * world's axes.
 */
final class Submerged {

    /** Longest arc in rad that is integrated in one piece. */
    private static final double LONGEST_ARC = Math.PI / 4;

    /**
     * Gauss–Legendre rule of eight points, half of it; its error for such an arc is below 1e-16 of
     * the integral.
     */
    private static final double[] GAUSS_PLACES = {
        0.18343464249564980, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623
    };

    private static final double[] GAUSS_WEIGHTS = {
        0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626
    };

    /** Submerged area, m². */
    double area;

    /** Centroid of that area, m; 0 where nothing is submerged. */
    double centroidX;

    double centroidY;

    /** ∫r² dA about the centre of mass, m⁴. */
    double secondMoment;

    private double level;

    /** The submerged outline: its first corner, and its last one so far. */
    private boolean isBegun;

    private double firstX;
    private double firstY;
    private double lastX;
    private double lastY;

    /** Sums over the triangles between the centre of mass and the edges of the outline. */
    private double twiceArea;

    private double momentX;
    private double momentY;
    private double momentSquared;

    /** Measures a body; the level in m is relative to its centre of mass. */
    void measure(Instant at, double heightOverCentre) {
        level = heightOverCentre;
        area = 0;
        centroidX = 0;
        centroidY = 0;
        secondMoment = 0;
        if (!(level > -at.boundingRadius)) {
            return;
        }
        if (at.shape.kind() == ShapeKind.CIRCLE) {
            measureDisc(at.boundingRadius);
            return;
        }
        twiceArea = 0;
        momentX = 0;
        momentY = 0;
        momentSquared = 0;
        for (int part = 0; part < at.shape.parts(); part++) {
            isBegun = false;
            Outline outline = at.shape.outline(part);
            if (at.shape.isSensor(part)) {
                continue;
            }
            if (outline.radius() > 0) {
                walkRound(outline, at.angle, at.cos(), at.sin());
            } else {
                walk(outline, at.cos(), at.sin());
            }
            close();
        }
        weigh();
    }

    /**
     * Measures the segment of a disc with the half angle φ, cos φ = −level/r: A = r²(φ − ½sin 2φ),
     * its centroid ⅔r³sin³φ/A below the centre, ∫r²dA = r⁴(φ/2 − sin 2φ/6 − sin 4φ/24).
     */
    private void measureDisc(double r) {
        double cos = Math.max(-1, -level / r);
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        double phi = Angle.acos(cos);
        double sin2 = 2 * sin * cos;
        double sin4 = 2 * sin2 * (2 * cos * cos - 1);
        area = r * r * (phi - sin2 / 2);
        if (area > 0) {
            centroidY = -2.0 / 3 * r * r * r * sin * sin * sin / area;
            secondMoment = r * r * r * r * (phi / 2 - sin2 / 6 - sin4 / 24);
        }
    }

    /** Walks round a sharp outline, and skips what is above the level. */
    private void walk(Outline polygon, double cos, double sin) {
        int count = polygon.corners();
        double fromX = worldX(polygon, count - 1, cos, sin);
        double fromY = worldY(polygon, count - 1, cos, sin);
        for (int i = 0; i < count; i++) {
            double toX = worldX(polygon, i, cos, sin);
            double toY = worldY(polygon, i, cos, sin);
            walkEdge(fromX, fromY, toX, toY);
            fromX = toX;
            fromY = toY;
        }
    }

    private void walkEdge(double fromX, double fromY, double toX, double toY) {
        if (fromY < level != toY < level) {
            go(fromX + (level - fromY) / (toY - fromY) * (toX - fromX), level);
        }
        if (toY < level) {
            go(toX, toY);
        }
    }

    /** Walks round a rounded outline: an arc about each corner, and the edges between the arcs. */
    private void walkRound(Outline outline, double angle, double cos, double sin) {
        int count = outline.corners();
        double radius = outline.radius();
        if (outline.isDisc()) {
            walkArc(
                    worldX(outline, 0, cos, sin),
                    worldY(outline, 0, cos, sin),
                    radius,
                    0,
                    2 * Math.PI);
            return;
        }
        int before = count - 1;
        for (int i = 0; i < count; i++) {
            double outX = radius * (cos * outline.normalX(before) - sin * outline.normalY(before));
            double outY = radius * (sin * outline.normalX(before) + cos * outline.normalY(before));
            double x = worldX(outline, i, cos, sin);
            double y = worldY(outline, i, cos, sin);
            walkEdge(
                    worldX(outline, before, cos, sin) + outX,
                    worldY(outline, before, cos, sin) + outY,
                    x + outX,
                    y + outY);
            double from = Angle.atan2(outline.normalY(before), outline.normalX(before));
            double to = Angle.atan2(outline.normalY(i), outline.normalX(i));
            double turn = to > from ? to - from : to - from + 2 * Math.PI;
            walkArc(x, y, radius, from + angle, turn);
            before = i;
        }
    }

    /** Cuts an arc where it crosses the level, and adds the pieces below it. */
    private void walkArc(double x, double y, double radius, double from, double turn) {
        double rises = Angle.asin(Math.max(-1, Math.min(1, (level - y) / radius)));
        double first = turnTo(rises, from);
        double second = turnTo(Math.PI - rises, from);
        double near = Math.min(turn, Math.min(first, second));
        double far = Math.min(turn, Math.max(first, second));
        goAlong(x, y, radius, from, near);
        goAlong(x, y, radius, from + near, far - near);
        goAlong(x, y, radius, from + far, turn - far);
    }

    /** Counter-clockwise turn from one angle to another, rad, 0 to 2π. */
    private static double turnTo(double angle, double from) {
        double turns = (angle - from) / (2 * Math.PI);
        return (turns - Math.floor(turns)) * (2 * Math.PI);
    }

    /**
     * Adds an arc that lies on one side of the level, if that is below. The sums over its triangles
     * are integrals of sines; Gauss–Legendre in pieces of at most an eighth of a turn is exact to
     * round-off.
     */
    private void goAlong(double x, double y, double radius, double from, double turn) {
        double middle = from + turn / 2;
        if (!(turn > 0) || !(y + radius * Angle.sin(middle) < level)) {
            return;
        }
        go(x + radius * Angle.cos(from), y + radius * Angle.sin(from));
        int pieces = (int) Math.ceil(turn / LONGEST_ARC);
        double half = turn / pieces / 2;
        for (int piece = 0; piece < pieces; piece++) {
            double centre = from + (2 * piece + 1) * half;
            for (int i = 0; i < GAUSS_PLACES.length; i++) {
                double weight = GAUSS_WEIGHTS[i] * half;
                addArc(x, y, radius, centre - GAUSS_PLACES[i] * half, weight);
                addArc(x, y, radius, centre + GAUSS_PLACES[i] * half, weight);
            }
        }
        lastX = x + radius * Angle.cos(from + turn);
        lastY = y + radius * Angle.sin(from + turn);
    }

    /**
     * Adds the triangle between the centre of mass and an infinitesimal piece of an arc, weighted
     * by {@code turn}.
     */
    private void addArc(double cx, double cy, double radius, double angle, double turn) {
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        double x = cx + radius * cos;
        double y = cy + radius * sin;
        double cross = (x * cos + y * sin) * radius * turn;
        twiceArea += cross;
        momentX += cross * 2 * x;
        momentY += cross * 2 * y;
        momentSquared += cross * 3 * (x * x + y * y);
    }

    private static double worldX(Outline polygon, int i, double cos, double sin) {
        return cos * polygon.cornerX(i) - sin * polygon.cornerY(i);
    }

    private static double worldY(Outline polygon, int i, double cos, double sin) {
        return sin * polygon.cornerX(i) + cos * polygon.cornerY(i);
    }

    private void go(double x, double y) {
        if (isBegun) {
            addTriangle(lastX, lastY, x, y);
        } else {
            firstX = x;
            firstY = y;
            isBegun = true;
        }
        lastX = x;
        lastY = y;
    }

    /**
     * Adds the triangle between the centre of mass and two points; a clockwise one counts as
     * negative.
     */
    private void addTriangle(double ax, double ay, double bx, double by) {
        double cross = ax * by - bx * ay;
        twiceArea += cross;
        momentX += cross * (ax + bx);
        momentY += cross * (ay + by);
        momentSquared += cross * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by);
    }

    private void close() {
        if (isBegun) {
            addTriangle(lastX, lastY, firstX, firstY);
        }
    }

    private void weigh() {
        if (twiceArea > 0) {
            area = twiceArea / 2;
            centroidX = momentX / (3 * twiceArea);
            centroidY = momentY / (3 * twiceArea);
            secondMoment = momentSquared / 12;
        }
    }
}

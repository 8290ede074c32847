package rigibo.backend.force;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.ShapeKind;

/**
 * What of a body is under a level: area, centroid and second moment, exactly. A plain carrier that
 * its owner reuses. Places are seen from the body's centre of mass, in the world's directions.
 */
final class Submerged {

    /** m². */
    double area;

    /** m; 0 where nothing is under water. */
    double centroidX;

    double centroidY;

    /** ∫r² dA about the centre of mass, m⁴. */
    double secondMoment;

    private double level;

    /** The outline under water: its first corner and the last one so far. */
    private boolean isBegun;

    private double firstX;
    private double firstY;
    private double lastX;
    private double lastY;

    /** Sums over the triangles between the centre and the outline's edges, by their weights. */
    private double twiceArea;

    private double momentX;
    private double momentY;
    private double momentSquared;

    /** Measures a body; the level in m is seen from its centre of mass. */
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
        } else {
            measurePolygon((Polygon) at.shape, at.cos(), at.sin());
        }
    }

    /**
     * The segment of a disc with the half angle φ, cos φ = −level/r: A = r²(φ − ½sin 2φ), its
     * centroid ⅔r³sin³φ/A under the centre, ∫r²dA = r⁴(φ/2 − sin 2φ/6 − sin 4φ/24).
     */
    private void measureDisc(double r) {
        double cos = Math.max(-1, -level / r);
        double sin = Math.sqrt((1 - cos) * (1 + cos));
        double phi = StrictMath.acos(cos);
        double sin2 = 2 * sin * cos;
        double sin4 = 2 * sin2 * (2 * cos * cos - 1);
        area = r * r * (phi - sin2 / 2);
        if (area > 0) {
            centroidY = -2.0 / 3 * r * r * r * sin * sin * sin / area;
            secondMoment = r * r * r * r * (phi / 2 - sin2 / 6 - sin4 / 24);
        }
    }

    /** Walks round the outline, leaving out what is over the level. */
    private void measurePolygon(Polygon polygon, double cos, double sin) {
        isBegun = false;
        twiceArea = 0;
        momentX = 0;
        momentY = 0;
        momentSquared = 0;
        int count = polygon.corners();
        double fromX = worldX(polygon, count - 1, cos, sin);
        double fromY = worldY(polygon, count - 1, cos, sin);
        for (int i = 0; i < count; i++) {
            double toX = worldX(polygon, i, cos, sin);
            double toY = worldY(polygon, i, cos, sin);
            if (fromY < level != toY < level) {
                go(fromX + (level - fromY) / (toY - fromY) * (toX - fromX), level);
            }
            if (toY < level) {
                go(toX, toY);
            }
            fromX = toX;
            fromY = toY;
        }
        close();
    }

    private static double worldX(Polygon polygon, int i, double cos, double sin) {
        return cos * polygon.cornerX(i) - sin * polygon.cornerY(i);
    }

    private static double worldY(Polygon polygon, int i, double cos, double sin) {
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

    /** The triangle of the centre of mass and two points; clockwise ones count negative. */
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
        if (twiceArea > 0) {
            area = twiceArea / 2;
            centroidX = momentX / (3 * twiceArea);
            centroidY = momentY / (3 * twiceArea);
            secondMoment = momentSquared / 12;
        }
    }
}

package rigibo.frontend.draw;

import rigibo.backend.geometry.Polygon;
import rigibo.frontend.scene.Layout;

import java.nio.FloatBuffer;

/**
 * Soft shadows of bodies, drawn by one call before the bodies. Each is the outline of its body,
 * moved away from the lamp and darker towards its middle.
 */
final class ShadowBatch {

    /** Radius below which a body throws no visible shadow, m. */
    private static final double LEAST = 0.09;

    /**
     * Width by which the edge of a shadow is smeared to either side, and the shadow's offset, m.
     */
    private static final double SMEAR = 0.085;

    private static final double FALL_X = 0.07;
    private static final double FALL_Y = 0.10;
    private static final float DARKNESS = 0.5f;

    /** Stands for the reach upwards if the body reaches equally far all round. */
    private static final double ROUND = -1;

    /** Position, way from the centre (px), how far it reaches there, smear and darkness. */
    private final Triangles triangles = new Triangles(2, 2, 2, 2);

    private OnScreen at = new OnScreen();

    /**
     * Adds the shadow of a body that is a number of times as far from the wall as one that lies on
     * it.
     */
    void add(Figure figure, OnScreen place, double height) {
        if (figure.halfSize() < LEAST) {
            return;
        }
        at = place;
        double fallX = FALL_X * height * at.scale();
        double fallY = FALL_Y * height * at.scale();
        at.shift(fallX, fallY);
        if (figure.isDisc) {
            square(figure.halfWidth, figure.halfWidth, ROUND);
        } else if (figure.isBox) {
            square(figure.halfWidth, figure.halfHeight, figure.halfHeight * at.scale());
        } else {
            fan(figure.polygon);
        }
        at.shift(-fallX, -fallY);
    }

    void draw(Program program, Layout layout) {
        triangles.draw(program, layout);
    }

    void free() {
        triangles.free();
    }

    private void square(double halfWidth, double halfHeight, double reachY) {
        double scale = at.scale();
        for (int i = 0; i < Triangles.SQUARE.length; i += 2) {
            double localX = Triangles.SQUARE[i] * (halfWidth + SMEAR);
            double localY = Triangles.SQUARE[i + 1] * (halfHeight + SMEAR);
            vertex(localX, localY, localX * scale, localY * scale, halfWidth * scale, reachY);
        }
    }

    /** Adds a fan about the centre whose sides lie one smear outside those of the polygon. */
    private void fan(Polygon polygon) {
        double scale = at.scale();
        double reach = polygon.boundingRadius() * scale;
        for (int i = 0; i < polygon.corners(); i++) {
            double inward =
                    polygon.normalX(i) * polygon.cornerX(i)
                            + polygon.normalY(i) * polygon.cornerY(i);
            vertex(0, 0, reach - inward * scale, 0, reach, ROUND);
            corner(polygon, i, reach);
            corner(polygon, (i + 1) % polygon.corners(), reach);
        }
    }

    /**
     * Intersection of the two sides that meet in a corner, after both were moved outwards by s: c +
     * s·(n₁ + n₂)/(1 + n₁·n₂).
     */
    private void corner(Polygon polygon, int i, double reach) {
        int before = (i + polygon.corners() - 1) % polygon.corners();
        double sumX = polygon.normalX(i) + polygon.normalX(before);
        double sumY = polygon.normalY(i) + polygon.normalY(before);
        double out = 2 * SMEAR / (sumX * sumX + sumY * sumY);
        double x = polygon.cornerX(i) + out * sumX;
        double y = polygon.cornerY(i) + out * sumY;
        vertex(x, y, reach + SMEAR * at.scale(), 0, reach, ROUND);
    }

    private void vertex(
            double localX, double localY, double wayX, double wayY, double reachX, double reachY) {
        FloatBuffer to = at.vertex(triangles, localX, localY);
        to.put((float) wayX).put((float) wayY).put((float) reachX).put((float) reachY);
        to.put((float) (SMEAR * at.scale())).put(DARKNESS);
    }
}

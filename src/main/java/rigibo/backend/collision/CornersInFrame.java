package rigibo.backend.collision;

import rigibo.backend.geometry.Polygon;

/** The corners of one polygon written in the frame of another, m. */
final class CornersInFrame {

    final double[] x = new double[Polygon.MAX_CORNERS];
    final double[] y = new double[Polygon.MAX_CORNERS];
    int count;

    /** Writes the corners of a polygon that sits at a relative place with a relative turn. */
    void write(Polygon polygon, double placeX, double placeY, double cos, double sin) {
        int corners = polygon.corners();
        count = corners;
        for (int i = 0; i < corners; i++) {
            double cx = polygon.cornerX(i);
            double cy = polygon.cornerY(i);
            x[i] = placeX + (cos * cx - sin * cy);
            y[i] = placeY + (sin * cx + cos * cy);
        }
    }

    int after(int corner) {
        return corner + 1 == count ? 0 : corner + 1;
    }

    int before(int corner) {
        return corner == 0 ? count - 1 : corner - 1;
    }
}

package rigibo.frontend.draw;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Polygon;

import java.util.Map;
import java.util.WeakHashMap;

/** A shape for drawing: a disc, a box or another polygon, and its bounding radius, m. */
final class Figure {

    /** The outlines of shapes that are neither discs nor sharp polygons; each is made once. */
    private final Map<Convex, Polygon> polygons = new WeakHashMap<>();

    private final Aabb bounds = new Aabb();

    /** The outline of any shape but a disc. */
    Polygon polygon;

    /** Distance from the centre to the farther side. */
    double halfWidth;

    double halfHeight;
    boolean isDisc;
    boolean isBox;

    void of(Convex of) {
        isDisc = of.outline().isDisc();
        if (!isDisc) {
            polygon = polygon(of);
        }
        Convex drawn = isDisc ? of : polygon;
        drawn.bounds(0, 0, 1, 0, bounds);
        halfWidth = Math.max(bounds.maxX, -bounds.minX);
        halfHeight = Math.max(bounds.maxY, -bounds.minY);
        isBox = !isDisc && isBox(polygon);
    }

    private Polygon polygon(Convex of) {
        boolean isSharp = of instanceof Polygon && of.outline().radius() == 0;
        return isSharp ? (Polygon) of : polygons.computeIfAbsent(of, RoundCorners::of);
    }

    /** Half the smaller side of the bounding rectangle, m. */
    double halfSize() {
        return Math.min(halfWidth, halfHeight);
    }

    private boolean isBox(Polygon polygon) {
        boolean isBox = polygon.corners() == 4;
        for (int i = 0; i < polygon.corners() && isBox; i++) {
            isBox =
                    Math.abs(polygon.cornerX(i)) == halfWidth
                            && Math.abs(polygon.cornerY(i)) == halfHeight;
        }
        return isBox;
    }
}

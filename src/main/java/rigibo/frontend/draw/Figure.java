package rigibo.frontend.draw;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

import java.util.Map;
import java.util.WeakHashMap;

/** A shape for drawing: a disc, a box or another polygon, and its bounding radius, m. */
final class Figure {

    /** Polygons with many corners for rounded shapes; each is made once. */
    private final Map<Convex, Polygon> polygons = new WeakHashMap<>();

    private final Aabb bounds = new Aabb();
    Shape shape;

    /** Distance from the centre to the farther side. */
    double halfWidth;

    double halfHeight;
    boolean isDisc;
    boolean isBox;

    void of(Convex of) {
        boolean isRounded = of.outline().radius() > 0 && !of.outline().isDisc();
        Convex drawn = isRounded ? polygons.computeIfAbsent(of, RoundCorners::of) : of;
        shape = drawn;
        drawn.bounds(0, 0, 1, 0, bounds);
        halfWidth = Math.max(bounds.maxX, -bounds.minX);
        halfHeight = Math.max(bounds.maxY, -bounds.minY);
        isDisc = drawn instanceof Circle;
        isBox = drawn instanceof Polygon polygon && isBox(polygon);
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

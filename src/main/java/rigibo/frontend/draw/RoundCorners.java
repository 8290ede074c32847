package rigibo.frontend.draw;

import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Polygon;

import java.util.ArrayList;
import java.util.List;

/** Outlines as polygons, with many corners for each round one. */
final class RoundCorners {

    /** Turn from one corner to the next, rad: 0.3 % of the radius is cut off. */
    private static final double LONGEST_TURN = 0.16;

    /** Corners from which on one each is round enough, and all that a polygon may have. */
    private static final int MANY = 64;

    private RoundCorners() {}

    static Polygon of(Convex shape) {
        Outline outline = shape.outline();
        int count = outline.corners();
        boolean isOneEach = count > MANY || outline.radius() == 0;
        List<Double> xy = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            int before = (i + count - 1) % count;
            double from = Math.atan2(outline.normalY(before), outline.normalX(before));
            double to = Math.atan2(outline.normalY(i), outline.normalX(i));
            double turn = to > from ? to - from : to - from + 2 * Math.PI;
            int pieces = isOneEach ? 1 : (int) Math.ceil(turn / LONGEST_TURN);
            int first = isOneEach ? 1 : 0;
            for (int piece = first; piece <= pieces; piece++) {
                double angle = from + turn * piece / pieces;
                xy.add(outline.cornerX(i) + outline.radius() * Math.cos(angle));
                xy.add(outline.cornerY(i) + outline.radius() * Math.sin(angle));
            }
        }
        return Polygon.of(xy.stream().mapToDouble(Double::doubleValue).toArray());
    }
}

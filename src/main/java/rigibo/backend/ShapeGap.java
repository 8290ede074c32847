package rigibo.backend;

/**
 * The gap between two shapes, and the two nearest points.
 *
 * <pre>{@code
 * ShapeGap gap =
 *         Geometry.gap(
 *                 new Circle(1), Placement.ORIGIN, Polygon.box(1, 1), Placement.at(3, 0));
 * System.out.println(gap.gap() + " m"); // 1.5 m
 * }</pre>
 *
 * @param gap distance of the two nearest parts, m; in overlap negative: minus the shortest
 *     displacement that would separate them
 * @param normalX unit vector from the first shape to the second, world x
 * @param normalY unit vector from the first shape to the second, world y
 * @param x nearest point of the first shape, world, m
 * @param y nearest point of the first shape, world, m
 * @param otherX nearest point of the second, world, m
 * @param otherY nearest point of the second, world, m
 * @param part index of the part of the first shape, from 0
 * @param otherPart index of the part of the second shape, from 0
 */
public record ShapeGap(
        double gap,
        double normalX,
        double normalY,
        double x,
        double y,
        double otherX,
        double otherY,
        int part,
        int otherPart) {}

package rigibo.backend;

/**
 * How far two shapes are apart, and between which points.
 *
 * <pre>{@code
 * ShapeGap gap =
 *         Geometry.gap(
 *                 new Circle(1), Placement.ORIGIN, Polygon.box(1, 1), Placement.at(3, 0));
 * System.out.println(gap.gap() + " m"); // 1.5 m
 * }</pre>
 *
 * @param gap m; in overlap minus the least way that would part the two parts
 * @param normalX unit vector from the first shape to the second, world x
 * @param normalY unit vector from the first shape to the second, world y
 * @param x nearest point of the first shape, world, m
 * @param y nearest point of the first shape, world, m
 * @param otherX nearest point of the second, world, m
 * @param otherY nearest point of the second, world, m
 * @param part which part of the first shape, from 0
 * @param otherPart which part of the second
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

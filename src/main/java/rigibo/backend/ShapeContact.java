package rigibo.backend;

import java.util.List;

/**
 * The contact of two convex parts that touch or nearly touch.
 *
 * <pre>{@code
 * Shape box = Polygon.box(1, 1);
 * for (ShapeContact contact :
 *         Geometry.contacts(box, Placement.ORIGIN, box, Placement.at(0.9, 0), 0)) {
 *     System.out.println(contact.points().size() + " points, the first " + contact.points().get(0));
 * }
 * }</pre>
 *
 * @param part index of the part of the first shape, from 0
 * @param otherPart index of the part of the second shape, from 0
 * @param normalX unit normal from the first to the second, world x
 * @param normalY unit normal from the first to the second, world y
 * @param points one point, or two where two faces are nearly parallel
 */
public record ShapeContact(
        int part, int otherPart, double normalX, double normalY, List<Point> points) {

    /**
     * A point of contact.
     *
     * @param x world x, midway between the two surfaces, m
     * @param y world y, midway between the two surfaces, m, up
     * @param gap along the normal, m; negative in overlap
     */
    public record Point(double x, double y, double gap) {}
}

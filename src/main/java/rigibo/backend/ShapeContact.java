package rigibo.backend;

import java.util.List;

/**
 * Where two convex parts touch or nearly touch.
 *
 * <pre>{@code
 * Shape box = Polygon.box(1, 1);
 * for (ShapeContact contact :
 *         Geometry.contacts(box, Placement.ORIGIN, box, Placement.at(0.9, 0), 0)) {
 *     System.out.println(contact.points().size() + " points, the first " + contact.points().get(0));
 * }
 * }</pre>
 *
 * @param part which part of the first shape, from 0
 * @param otherPart which part of the second
 * @param normalX unit normal from the first to the second, world x
 * @param normalY unit normal from the first to the second, world y
 * @param points one, or two where faces are near parallel
 */
public record ShapeContact(
        int part, int otherPart, double normalX, double normalY, List<Point> points) {

    /**
     * A point of contact.
     *
     * @param x world, midway between the two surfaces, m
     * @param y world, m, up
     * @param gap along the normal, m; negative in overlap
     */
    public record Point(double x, double y, double gap) {}
}

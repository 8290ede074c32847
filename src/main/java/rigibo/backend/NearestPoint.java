package rigibo.backend;

/**
 * The point of a body that is nearest to a query point.
 *
 * <pre>{@code
 * pool.nearest(0, 1, 5, Filter.ALL) // within 5 m
 *         .ifPresent(point -> System.out.println(point.distance() + " m from " + point.body()));
 * }</pre>
 *
 * @param body the body that has the point
 * @param part index of the part of its shape, from 0
 * @param x world x, m; the query point itself if that lies inside the body
 * @param y world y, m, up
 * @param distance distance from the query point, m; 0 if that lies inside the body
 */
public record NearestPoint(RigidBody body, int part, double x, double y, double distance) {}

package rigibo.backend;

/**
 * The point of a body that is nearest to another point.
 *
 * <pre>{@code
 * pool.nearest(0, 1, 5, Filter.ALL) // within 5 m
 *         .ifPresent(point -> System.out.println(point.distance() + " m from " + point.body()));
 * }</pre>
 *
 * @param body whose point it is
 * @param part which part of its shape, from 0
 * @param x world x, m; the point asked for itself where that is inside
 * @param y world y, m, up
 * @param distance from the point asked for, m; 0 inside
 */
public record NearestPoint(RigidBody body, int part, double x, double y, double distance) {}

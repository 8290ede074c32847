package rigibo.backend;

/**
 * Where a ray meets the first body on its way.
 *
 * <pre>{@code
 * pool.rayCast(0, 5, 0, -5)
 *         .ifPresent(hit -> System.out.println(hit.body() + " is " + 10 * hit.fraction() + " m away"));
 * }</pre>
 *
 * @param body the body met
 * @param part which part of its shape, from 0; 0 of a shape in one piece
 * @param x world x of the point, m
 * @param y world y of the point, m
 * @param normalX outward unit normal of the outline there
 * @param normalY outward unit normal of the outline there
 * @param fraction of the way from the ray's start to its end, 0 to 1
 */
public record RayHit(
        RigidBody body,
        int part,
        double x,
        double y,
        double normalX,
        double normalY,
        double fraction) {}

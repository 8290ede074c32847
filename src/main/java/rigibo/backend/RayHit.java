package rigibo.backend;

/**
 * Where a ray, or a swept shape, hits a body.
 *
 * <pre>{@code
 * pool.rayCast(0, 5, 0, -5)
 *         .ifPresent(hit -> System.out.println(hit.body() + " is " + 10 * hit.fraction() + " m away"));
 * }</pre>
 *
 * @param body the body that was hit
 * @param part index of the part of its shape, from 0; 0 for a shape in one piece
 * @param x world x of the point of contact, m
 * @param y world y of the point of contact, m, up
 * @param normalX outward unit normal of the body there, world x
 * @param normalY outward unit normal of the body there, world y
 * @param fraction of the path from start to end, 0 to 1
 */
public record RayHit(
        RigidBody body,
        int part,
        double x,
        double y,
        double normalX,
        double normalY,
        double fraction) {}

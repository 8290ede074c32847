package rigibo.backend;

/**
 * An impact of the last step: plain data, read after the step. A ball that bounces twice within a
 * step causes two. For bodies in flight, and for those that land on a pile, time and speed are as
 * accurate as {@code Accuracy.impactTolerance}; for an impact inside a pile, speed and place are
 * those of its substep.
 *
 * <p>Resting, sliding and rolling contacts cause no hit, nor do contacts inside a pile that close
 * without bouncing; the {@link ContactEvent} holds their impulse. Hits of bodies in flight need the
 * effect {@code ContinuousImpacts}, without which no time of impact is searched for.
 *
 * <pre>{@code
 * for (HitEvent hit : pool.hits()) {
 *     System.out.println(hit.a() + " met " + hit.b() + " at " + hit.speed() + " m/s");
 * }
 * }</pre>
 *
 * @param a the body the normal points away from
 * @param b the body the normal points to
 * @param partA index of the part of a's shape that was hit, from 0; 0 for a shape in one piece
 * @param partB index of the part of b's shape that was hit
 * @param x world x of the midpoint of the contact, m
 * @param y world y of the midpoint of the contact, m, up
 * @param normalX unit normal from a to b
 * @param normalY unit normal from a to b
 * @param speed closing speed along the normal before the impact, at the fastest point, m/s,
 *     positive
 * @param time time of the impact since the start of the step, s, 0 to the step's length
 */
public record HitEvent(
        RigidBody a,
        RigidBody b,
        int partA,
        int partB,
        double x,
        double y,
        double normalX,
        double normalY,
        double speed,
        double time) {}

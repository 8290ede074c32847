package rigibo.backend;

/**
 * An impact of the last step; plain data, read after the step. A ball that bounces twice within a
 * step tells two. Bodies in flight tell when and how fast they met to what {@code
 * Accuracy.impactTolerance} grants, those that land on a pile too; what strikes within a pile tells
 * the substep's own speed and place.
 *
 * <p>What rests, slides or rolls tells none, and within a pile neither does what meets without
 * bouncing: its impulse is that of the {@link ContactEvent}. Bodies in flight are told only where
 * {@code ContinuousImpacts} are declared, for else nothing looks for the time they meet.
 *
 * <pre>{@code
 * for (HitEvent hit : pool.hits()) {
 *     System.out.println(hit.a() + " met " + hit.b() + " at " + hit.speed() + " m/s");
 * }
 * }</pre>
 *
 * @param a the body the normal points away from
 * @param b the body the normal points to
 * @param partA which part of a's shape was met, from 0; 0 of a shape in one piece
 * @param partB which part of b's shape was met
 * @param x world x of the middle of what met, m
 * @param y world y of the middle of what met, m
 * @param normalX unit normal from a to b
 * @param normalY unit normal from a to b
 * @param speed at which the two came together along the normal, at the fastest point, m/s, positive
 * @param time s after the step began, 0 to its length
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

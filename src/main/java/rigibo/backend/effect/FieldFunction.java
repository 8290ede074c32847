package rigibo.backend.effect;

/**
 * What a {@link Field} does to a body at a place. Called many times within a step, also for places
 * the body will not come to; it must answer the same numbers with the same force, allocate nothing
 * and change nothing but the point it is given. A body on which the force is not finite is put to
 * rest and named in the step's report.
 *
 * <pre>{@code
 * FieldFunction whirl = at -> at.accelerate(-2 * at.y, 2 * at.x);
 * Pool pond = new Pool(Effects.of(new Field(whirl)), Accuracy.GAME);
 * }</pre>
 */
@FunctionalInterface
public interface FieldFunction {

    /** Adds to the point's force with {@link FieldPoint#push} or {@link FieldPoint#accelerate}. */
    void act(FieldPoint point);
}

package rigibo.backend.effect;

/**
 * The force of a {@link Field} on a body in a given state. It is called many times within a step,
 * also for states that the body will not reach. Equal inputs must give an equal force; the function
 * must allocate nothing and change nothing but the point it is given. A body whose force is not
 * finite is put to rest and named in the step's report.
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

package rigibo.backend.effect;

/**
 * Bodies turn; left out, they only translate and count as infinitely hard to turn. What was stated
 * of their spin is not kept then: when this is declared later, they begin to turn from rest.
 *
 * <pre>{@code
 * // Nothing turns: discs without friction, crowds, particles.
 * Pool discs = new Pool(Effects.usual().without(Rotation.class), Accuracy.GAME);
 * }</pre>
 */
public record Rotation() implements Effect {}

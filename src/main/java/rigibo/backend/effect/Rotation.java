package rigibo.backend.effect;

/**
 * Bodies turn. Without this effect they only translate, as if their moment of inertia were
 * infinite, and their spin is not kept: if it is declared later, they start to turn from rest.
 *
 * <pre>{@code
 * // Nothing turns: discs without friction, crowds, particles.
 * Pool discs = new Pool(Effects.usual().without(Rotation.class), Accuracy.GAME);
 * }</pre>
 */
public record Rotation() implements Effect {
    @Override
    public Kind kind() {
        return Kind.ROTATION;
    }
}

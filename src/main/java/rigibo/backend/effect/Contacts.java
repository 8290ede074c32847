package rigibo.backend.effect;

/**
 * Bodies collide and rest on each other. Without this effect they pass through each other.
 *
 * <pre>{@code
 * Pool floats = new Pool(Effects.of(new Contacts(), new Rotation()), Accuracy.GAME);
 * }</pre>
 */
public record Contacts() implements Effect {
    @Override
    public Kind kind() {
        return Kind.CONTACTS;
    }
}

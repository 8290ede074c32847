package rigibo.backend.effect;

import rigibo.backend.setup.Require;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The set of effects that a pool declares. It holds at most one effect of each kind, and every
 * effect that another one needs.
 *
 * <pre>{@code
 * Effects slippery = Effects.usual().without(Friction.class);
 * Effects moon = slippery.with(new Gravity(0, -1.62));
 * }</pre>
 */
public final class Effects {

    private final List<Effect> declared;

    private Effects(List<Effect> effects) {
        declared = Collections.unmodifiableList(effects);
        for (Effect effect : declared) {
            requireCompanions(effect);
        }
    }

    /**
     * A set of effects.
     *
     * @param effects in any order, each kind at most once
     * @throws IllegalArgumentException when an effect is null, declared twice, or needs an effect
     *     that is not declared, naming both
     */
    public static Effects of(Effect... effects) {
        Require.present("Effects.of effects", effects);
        List<Effect> once = new ArrayList<>();
        for (Effect effect : effects) {
            Require.present("Effects.of effect", effect);
            if (once.stream().anyMatch(other -> other.kind() == effect.kind())) {
                throw new IllegalArgumentException(
                        "Effects.of declares " + effect.kind().typeName() + " twice");
            }
            once.add(effect);
        }
        return new Effects(once);
    }

    /** Gravity, contacts, rotation, friction, restitution, continuous impacts and sleep. */
    public static Effects usual() {
        return of(
                new Gravity(0, -9.81),
                new Contacts(),
                new Rotation(),
                new Friction(),
                new Restitution(),
                new ContinuousImpacts(),
                new Sleep());
    }

    /** The declared effects in the order they were given, as a read-only list. */
    public List<Effect> all() {
        return declared;
    }

    /** Whether an effect of this kind is declared. */
    public boolean declares(Class<? extends Effect> kind) {
        return find(kind).isPresent();
    }

    /** The declared effect of a kind, or empty if none is declared. */
    public <T extends Effect> Optional<T> find(Class<T> kind) {
        return declared.stream().filter(kind::isInstance).map(kind::cast).findFirst();
    }

    /** Whether one of the effects holds a caller's function, which a snapshot cannot save. */
    public boolean holdFunctions() {
        return declared.stream().anyMatch(Effect::holdsFunction);
    }

    /**
     * A copy with one more effect, which replaces one of the same kind.
     *
     * @throws IllegalArgumentException when the effect needs another one that is not declared
     */
    public Effects with(Effect effect) {
        Require.present("Effects.with effect", effect);
        List<Effect> next = new ArrayList<>(declared);
        next.removeIf(other -> other.kind() == effect.kind());
        next.add(effect);
        return new Effects(next);
    }

    /**
     * A copy without the effect of a kind.
     *
     * @throws IllegalArgumentException when another declared effect needs it
     */
    public Effects without(Class<? extends Effect> kind) {
        Require.present("Effects.without kind", kind);
        List<Effect> next = new ArrayList<>(declared);
        next.removeIf(kind::isInstance);
        return new Effects(next);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Effects && declared.equals(((Effects) other).declared);
    }

    @Override
    public int hashCode() {
        return declared.hashCode();
    }

    @Override
    public String toString() {
        return "Effects" + declared;
    }

    private void requireCompanions(Effect effect) {
        for (List<Effect.Kind> companions : effect.needs()) {
            if (declared.stream().noneMatch(other -> companions.contains(other.kind()))) {
                throw new IllegalArgumentException(
                        effect.kind().typeName() + " needs " + missing(companions));
            }
        }
    }

    private static String missing(List<Effect.Kind> companions) {
        String names =
                companions.stream().map(Effect.Kind::typeName).collect(Collectors.joining(" or "));
        return names
                + (companions.size() == 1
                        ? ", which is not declared"
                        : ", neither of which is declared");
    }
}

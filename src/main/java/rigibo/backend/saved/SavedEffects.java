package rigibo.backend.saved;

import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * The effects that a snapshot declares. Of an effect that holds a function only the kind is
 * written; the caller must pass it again when restoring.
 */
final class SavedEffects {

    /** Bytes of a name's length, of the flag for a function, and of the number of values. */
    private static final int LEAST_BYTES = 5;

    private final List<Effect> effects = new ArrayList<>();
    private final Set<String> kinds = new TreeSet<>();
    private final Set<String> withFunction = new TreeSet<>();

    private SavedEffects() {}

    static void write(Effects effects, ByteWriter writer) {
        writer.label("effects");
        writer.count(effects.all().size(), LEAST_BYTES);
        for (Effect effect : effects.all()) {
            String kind = writer.text(effect.kind().typeName());
            if (!writer.flag(effect.holdsFunction())) {
                writer.value(form(kind), effect);
            }
        }
    }

    static SavedEffects read(ByteReader reader) {
        SavedEffects saved = new SavedEffects();
        reader.label("effects");
        for (int left = reader.count(0, LEAST_BYTES); left > 0; left--) {
            saved.readOne(reader);
        }
        return saved;
    }

    private void readOne(ByteReader reader) {
        String kind = reader.text("");
        kinds.add(kind);
        if (reader.flag(false)) {
            withFunction.add(kind);
        } else {
            effects.add(reader.value(form(kind), null));
        }
    }

    /**
     * The effects as they were declared.
     *
     * @throws IllegalArgumentException naming those that hold a function
     */
    Effects declared() {
        if (!withFunction.isEmpty()) {
            throw new IllegalArgumentException(
                    "declares effects that hold a function, which cannot be written, "
                            + withFunction
                            + ": hand in all effects, as in Pool.restore(snapshot, effects)");
        }
        return Effects.of(effects.toArray(new Effect[0]));
    }

    /**
     * The caller's effects in place of those declared.
     *
     * @throws IllegalArgumentException when they are not of the same kinds, naming the difference
     */
    Effects replacedBy(Effects given) {
        Set<String> missing = new TreeSet<>(kinds);
        Set<String> surplus = new TreeSet<>();
        for (Effect effect : given.all()) {
            if (!missing.remove(effect.kind().typeName())) {
                surplus.add(effect.kind().typeName());
            }
        }
        if (!missing.isEmpty() || !surplus.isEmpty()) {
            throw new IllegalArgumentException(
                    "must be given effects of the kinds it declares, lacks "
                            + missing
                            + " and does not declare "
                            + surplus);
        }
        return given;
    }

    /**
     * The form of the effects of a kind.
     *
     * @throws IllegalArgumentException when no effect is called so, or none is made of numbers
     */
    private static Form<Effect> form(String kind) {
        return Arrays.stream(Effect.Kind.values())
                .filter(one -> one.isMadeOfNumbers() && one.typeName().equals(kind))
                .findFirst()
                .map(one -> new Form<>(kind, one.numbers(), Effect::numbers, one::of))
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "declares the effect "
                                                + kind
                                                + ", for which there is no form"));
    }
}

package rigibo.lab.ablation.probe;

import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Thrust;

import java.util.ArrayList;
import java.util.List;

/**
 * A scene without one of its effects and without those that need it.
 *
 * @param scene the whole scene
 * @param effect simple name of the effect left out
 * @param remaining the effects still declared
 */
public record LeftOut(Workload scene, String effect, Effects remaining) {

    /**
     * The scene without an effect.
     *
     * @param effect its simple name
     * @throws IllegalArgumentException when the scene does not declare it
     */
    public static LeftOut of(Workload scene, String effect) {
        return new LeftOut(scene, effect, without(scene.effects(), effect));
    }

    private static Effects without(Effects declared, String name) {
        List<Effect> candidates = new ArrayList<>(declared.all());
        if (!candidates.removeIf(one -> one.getClass().getSimpleName().equals(name))) {
            throw new IllegalArgumentException(name + " is not among " + declared);
        }
        Effects kept = Effects.of();
        int before;
        // An effect that needs another is accepted in the round after the other.
        do {
            before = candidates.size();
            for (Effect candidate : List.copyOf(candidates)) {
                if (isAccepted(kept, candidate)) {
                    kept = kept.with(candidate);
                    candidates.remove(candidate);
                }
            }
        } while (candidates.size() < before);
        return Effects.of(
                declared.all().stream().filter(kept.all()::contains).toArray(Effect[]::new));
    }

    /**
     * Whether an effect can be declared beside others; only {@link Effects} knows, and refuses it
     * if not.
     */
    private static boolean isAccepted(Effects kept, Effect candidate) {
        try {
            kept.with(candidate);
            return true;
        } catch (IllegalArgumentException needsAnother) {
            return false;
        }
    }

    /** The other effects that are left out, since they need the one that is. */
    public List<String> companions() {
        return scene.effects().all().stream()
                .filter(one -> !remaining.all().contains(one))
                .map(one -> one.getClass().getSimpleName())
                .filter(name -> !name.equals(effect))
                .toList();
    }

    /** The scene with the remaining effects; it is driven only if thrust is one of them. */
    Workload rest() {
        boolean isDriven = remaining.declares(Thrust.class);
        return scene.with(remaining, scene.laidOut(), isDriven ? scene.drive() : Workload.UNDRIVEN);
    }
}

package rigibo.lab.ablation.probe;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Thrust;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/** A scene without one of its effects and without those that need it. */
public final class LeftOut implements Workload {

    private final Workload scene;
    private final String effect;
    private final Effects remaining;
    private final boolean isDriven;

    /**
     * The scene without an effect.
     *
     * @param effect its simple name
     * @throws IllegalArgumentException when the scene does not declare it
     */
    public LeftOut(Workload scene, String effect) {
        this.scene = scene;
        this.effect = effect;
        remaining = without(scene.effects(), effect);
        isDriven = remaining.declares(Thrust.class);
    }

    private static Effects without(Effects declared, String name) {
        List<Effect> candidates = new ArrayList<>(declared.all());
        if (!candidates.removeIf(one -> one.getClass().getSimpleName().equals(name))) {
            throw new IllegalArgumentException(name + " is not among " + declared);
        }
        Effects kept = Effects.of();
        int before;
        // One that needs another is accepted in the round after that one.
        do {
            before = candidates.size();
            for (Effect candidate : List.copyOf(candidates)) {
                if (isAccepted(kept, candidate)) {
                    kept = kept.with(candidate);
                    candidates.remove(candidate);
                }
            }
        } while (candidates.size() < before);
        return inOrder(declared, kept);
    }

    /** Effects alone know what they need, and say so by refusing. */
    private static boolean isAccepted(Effects kept, Effect candidate) {
        try {
            kept.with(candidate);
            return true;
        } catch (IllegalArgumentException needsAnother) {
            return false;
        }
    }

    private static Effects inOrder(Effects declared, Effects kept) {
        return Effects.of(
                declared.all().stream().filter(kept.all()::contains).toArray(Effect[]::new));
    }

    /** The effects left out because they need the one that was. */
    public List<String> companions() {
        return scene.effects().all().stream()
                .filter(one -> !remaining.all().contains(one))
                .map(one -> one.getClass().getSimpleName())
                .filter(name -> !name.equals(effect))
                .toList();
    }

    @Override
    public String name() {
        return scene.name() + " without " + effect;
    }

    @Override
    public String words() {
        return scene.words() + ", without " + effect;
    }

    @Override
    public Effects effects() {
        return remaining;
    }

    @Override
    public List<BodyDefinition> bodies() {
        return scene.bodies();
    }

    @Override
    public int stepsToSettle() {
        return scene.stepsToSettle();
    }

    @Override
    public int period() {
        return scene.period();
    }

    @Override
    public void drive(Pool pool) {
        if (isDriven) {
            scene.drive(pool);
        }
    }
}

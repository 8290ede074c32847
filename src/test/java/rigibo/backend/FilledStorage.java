package rigibo.backend;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.step.StepPlan;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/**
 * A storage with bodies in it, written as the public door writes them, and no step taken: what a
 * test of a single room starts from.
 */
public final class FilledStorage {

    public final DataStorage data;
    public final Bodies bodies;
    public final Pairs pairs;
    private final StepPlan plan;
    private final BodyEditor editor;

    /** Empty, with the columns of these effects, at {@link Accuracy#GAME}. */
    public FilledStorage(Effect... effects) {
        this(Accuracy.GAME, effects);
    }

    /** Empty, with the columns that these effects need at an accuracy. */
    public FilledStorage(Accuracy accuracy, Effect... effects) {
        Effects declared = Effects.of(effects);
        data = new DataStorage(declared);
        bodies = data.bodies;
        pairs = data.pairs;
        plan = new StepPlan(data, declared, accuracy);
        // Adds only: the pool would hear of the contacts that other edits end.
        editor = new BodyEditor(new Pool(declared, accuracy), data, plan);
    }

    /** Adds a body; returns its slot. */
    public int add(BodyDefinition definition) {
        int slot = editor.add(definition);
        data.roster.refresh(bodies);
        return slot;
    }

    /**
     * Makes a pair of two bodies, the lower slot first, that this step looks at; no contact yet.
     */
    public int pair(int a, int b) {
        int pair = pairs.add(bodies, a, b);
        pairs.activate(pair);
        return pair;
    }

    /** Takes one step of so many seconds with all its parts. */
    public void step(double dt) {
        plan.run(dt, () -> 0);
    }

    /** Where the bodies' fixtures hang; null where contacts are not declared. */
    public Broadphase broadphase() {
        return plan.broadphase();
    }
}

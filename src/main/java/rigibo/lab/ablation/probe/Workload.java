package rigibo.lab.ablation.probe;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyDefinition;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * A scene that is measured: it runs for a period, is put back, and runs again in the same way.
 *
 * @param name one word for the command line and the tables
 * @param words a description
 * @param effects that it declares
 * @param laidOut its bodies, in the order they are added
 * @param stepsToSettle before the state with which every period begins
 * @param period steps until it is put back, as long as it keeps moving
 * @param drive before each step; allocates nothing
 */
public record Workload(
        String name,
        String words,
        Effects effects,
        Supplier<List<BodyDefinition>> laidOut,
        int stepsToSettle,
        int period,
        Consumer<Pool> drive) {

    /** The drive of a scene that needs none. */
    static final Consumer<Pool> UNDRIVEN = pool -> {};

    /** Its bodies, in the order they are added. */
    public List<BodyDefinition> bodies() {
        return laidOut.get();
    }

    /** This scene under other effects, with other bodies and another driver. */
    Workload with(
            Effects others, Supplier<List<BodyDefinition>> bodies, Consumer<Pool> otherDrive) {
        return new Workload(name, words, others, bodies, stepsToSettle, period, otherDrive);
    }
}

package rigibo.frontend.laboratory;

import rigibo.backend.Pool;
import rigibo.backend.StepReport;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.accuracy.StepTimes;

/** One of the two worlds: a pool, its accuracy, its last step and its energy balance. */
final class Half {

    private static final double NANOS_PER_MILLI = 1e6;

    private final StepTimes times = new StepTimes();
    private Preset preset;
    private Accuracy accuracy;
    private Pool pool;
    private StepReport report;
    private double energyAtStart;

    Half(Preset preset) {
        this.preset = preset;
        accuracy = preset.accuracy();
    }

    /** Continues with a pool that begins now. */
    void begin(Pool fresh) {
        pool = fresh;
        pool.accuracy(accuracy);
        pool.clock(System::nanoTime);
        energyAtStart = energy();
        times.forget();
    }

    /** Continues at another accuracy from the present state. */
    void choose(Preset chosen) {
        preset = chosen;
        choose(chosen.accuracy());
    }

    /** Continues at an accuracy of the player's own. */
    void choose(Accuracy chosen) {
        accuracy = chosen;
        pool.accuracy(accuracy);
        times.forget();
    }

    void step() {
        report = pool.step(Scene.STEP);
        times.add(report);
    }

    /** The report of the last step; not before the first step. */
    StepReport report() {
        return report;
    }

    Accuracy accuracy() {
        return accuracy;
    }

    /** Whether its accuracy is one of the player's own instead of a preset. */
    boolean isOwn() {
        return Preset.of(accuracy).isEmpty();
    }

    Pool pool() {
        return pool;
    }

    /** The preset that was chosen last. */
    Preset preset() {
        return preset;
    }

    /** Time of a step, ms; 0 before the first. */
    double medianMillis() {
        return times.median() / NANOS_PER_MILLI;
    }

    /** Time of the last step, ms. */
    double lastMillis() {
        return times.last() / NANOS_PER_MILLI;
    }

    /** Energy of motion and of height above the floor, as a share of the initial energy. */
    double energyShare() {
        return energy() / energyAtStart;
    }

    private double energy() {
        return pool.kineticEnergy() + pool.potentialEnergy();
    }
}

package rigibo.frontend.laboratory;

import rigibo.backend.Pool;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.accuracy.StepTimes;

/** One of the two worlds: a pool, its accuracy, the time of its steps and its energy balance. */
final class Half {

    private static final double NANOS_PER_MILLI = 1e6;

    private final StepTimes times = new StepTimes();
    private Preset preset;
    private Pool pool;
    private double energyAtStart;

    Half(Preset preset) {
        this.preset = preset;
    }

    /** Continues with a pool that begins now. */
    void begin(Pool fresh) {
        pool = fresh;
        pool.accuracy(preset.accuracy());
        pool.clock(System::nanoTime);
        energyAtStart = energy();
        times.forget();
    }

    /** Continues at another accuracy from the present state. */
    void choose(Preset chosen) {
        preset = chosen;
        pool.accuracy(preset.accuracy());
        times.forget();
    }

    void step() {
        times.add(pool.step(Scene.STEP));
    }

    Pool pool() {
        return pool;
    }

    Preset preset() {
        return preset;
    }

    /** Time of a step, ms; 0 before the first. */
    double medianMillis() {
        return times.median() / NANOS_PER_MILLI;
    }

    /** Energy of motion and of height above the floor, as a share of the initial energy. */
    double energyShare() {
        return energy() / energyAtStart;
    }

    private double energy() {
        return pool.kineticEnergy() + pool.potentialEnergy();
    }
}

package rigibo.lab.bench.workers;

import rigibo.backend.StepReport;
import rigibo.lab.bench.probe.StepTimes;
import rigibo.lab.bench.scene.BenchScene;

import java.util.Arrays;

/** Times of the steps of a scene by a crew. */
final class WorkersCourse {

    private final BenchScene scene;
    private final Crew crew;

    /** ns by step and run. */
    private final double[][] wall;

    /** ns of all threads of the process, by step and run. */
    private final double[][] processor;

    private int sharedSteps;

    private long splits;

    WorkersCourse(BenchScene scene, Crew crew, int steps, int runs) {
        this.scene = scene;
        this.crew = crew;
        wall = new double[steps][runs];
        processor = new double[steps][runs];
    }

    BenchScene scene() {
        return scene;
    }

    Crew crew() {
        return crew;
    }

    void note(int run, int step, double nanos, double ofProcess, StepReport report) {
        wall[step][run] = nanos;
        processor[step][run] = ofProcess;
        sharedSteps += run == 0 && report.splits() > 0 ? 1 : 0;
        splits += run == 0 ? report.splits() : 0;
    }

    /** The share of the steps whose work was shared by workers. */
    double shared() {
        return sharedSteps / (double) wall.length;
    }

    /** How often workers meet in a step, in the mean. */
    double meetings() {
        return splits / (double) wall.length;
    }

    /** The wall-clock times of the steps, medians over the runs, ns. */
    StepTimes wall() {
        return medians(wall);
    }

    /** The processor times of all threads, medians over the runs, ns. */
    StepTimes processor() {
        return medians(processor);
    }

    private static StepTimes medians(double[][] times) {
        return new StepTimes(
                Arrays.stream(times).mapToDouble(runs -> new StepTimes(runs).median()).toArray());
    }
}

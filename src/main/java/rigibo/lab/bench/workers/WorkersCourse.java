package rigibo.lab.bench.workers;

import rigibo.backend.StepReport;
import rigibo.lab.bench.scene.BenchScene;

import java.util.Arrays;

/** Times of the steps of a scene by a number of workers. */
final class WorkersCourse {

    private static final double TAIL = 0.99;

    private final BenchScene scene;
    private final int workers;

    /** ns by step and run. */
    private final double[][] wall;

    /** ns of all threads of the process, by step and run. */
    private final double[][] processor;

    private int sharedSteps;

    WorkersCourse(BenchScene scene, int workers, int steps, int runs) {
        this.scene = scene;
        this.workers = workers;
        wall = new double[steps][runs];
        processor = new double[steps][runs];
    }

    BenchScene scene() {
        return scene;
    }

    int workers() {
        return workers;
    }

    void note(int run, int step, double nanos, double ofProcess, StepReport report) {
        wall[step][run] = nanos;
        processor[step][run] = ofProcess;
        sharedSteps += run == 0 && report.sharedIslands() > 0 ? 1 : 0;
    }

    /** Share of the steps in which islands were shared. */
    double shared() {
        return sharedSteps / (double) wall.length;
    }

    /** Mean over the steps of the medians over the runs, ns. */
    double mean() {
        return Arrays.stream(medians(wall)).average().orElseThrow();
    }

    double ofProcess() {
        return Arrays.stream(medians(processor)).average().orElseThrow();
    }

    double tail() {
        double[] sorted = medians(wall);
        return sorted[(int) (TAIL * (sorted.length - 1))];
    }

    double most() {
        double[] sorted = medians(wall);
        return sorted[sorted.length - 1];
    }

    /** Medians over the runs, ascending. */
    private static double[] medians(double[][] times) {
        return Arrays.stream(times)
                .mapToDouble(
                        runs -> {
                            double[] sorted = runs.clone();
                            Arrays.sort(sorted);
                            return sorted[sorted.length / 2];
                        })
                .sorted()
                .toArray();
    }
}

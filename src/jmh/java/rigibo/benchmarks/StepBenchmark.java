package rigibo.benchmarks;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import rigibo.backend.Pool;
import rigibo.backend.StepReport;

/** Steps a second, and the shares of the stages. */
@State(Scope.Benchmark)
@Fork(2)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class StepBenchmark {

    @Param public BenchmarkScene scene;

    private Pool pool;

    @Setup
    public void make() {
        pool = scene.make();
        pool.clock(System::nanoTime);
    }

    @Benchmark
    public StepReport step(StageTimes times) {
        StepReport report = pool.step(BenchmarkScene.STEP);
        times.add(report);
        return report;
    }
}

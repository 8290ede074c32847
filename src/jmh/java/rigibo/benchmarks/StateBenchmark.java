package rigibo.benchmarks;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import rigibo.backend.Pool;

import java.util.concurrent.TimeUnit;

/** The time to save a state, to restore it and to compare it. */
@State(Scope.Benchmark)
@Fork(2)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class StateBenchmark {

    @Param public BenchmarkScene scene;

    private Pool pool;
    private byte[] saved;

    @Setup
    public void make() {
        pool = scene.make();
        saved = pool.snapshot();
    }

    @Benchmark
    public byte[] snapshot() {
        return pool.snapshot();
    }

    @Benchmark
    public Pool restore() {
        return Pool.restore(saved);
    }

    @Benchmark
    public long stateHash() {
        return pool.stateHash();
    }
}

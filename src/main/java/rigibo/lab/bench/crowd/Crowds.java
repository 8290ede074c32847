package rigibo.lab.bench.crowd;

import rigibo.lab.child.Fields;
import rigibo.lab.child.Kept;
import rigibo.lab.child.MeasuringJava;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Simulates floods of every size in every engine, each in its own process. */
public final class Crowds {

    private final List<Integer> sizes;
    private final int warm;
    private final int timed;

    private Crowds(List<Integer> sizes, int warm, int timed) {
        this.sizes = sizes;
        this.warm = warm;
        this.timed = timed;
    }

    /** A short run with up to 1,000 discs. */
    public static Crowds quick() {
        return new Crowds(List.of(100, 1000), 90, 45);
    }

    /** The full run: up to 10,000 discs, until they are at rest. */
    public static Crowds full() {
        return new Crowds(List.of(100, 300, 1000, 3000, 10_000), 150, 90);
    }

    /**
     * Makes the runs that are missing.
     *
     * @param kept the results so far
     * @param tell is told how far it is
     * @return by engine and size
     * @throws IllegalStateException when a process breaks off, with what it said
     */
    public List<CrowdPoint> pour(Kept kept, Consumer<String> tell) {
        MeasuringJava java = MeasuringJava.onLastCore();
        List<List<String>> runs = new ArrayList<>();
        for (Engine engine : Engines.all()) {
            for (int size : sizes) {
                runs.add(List.of(engine.name(), "" + size, "" + warm, "" + timed));
            }
        }
        kept.make(
                runs, Crowds::name, run -> java.run(CrowdProbe.class, run, CrowdProbe.MARK), tell);
        return runs.stream()
                .map(run -> Fields.parse(CrowdPoint.class, kept.of(name(run)).orElseThrow()))
                .toList();
    }

    private static String name(List<String> run) {
        return String.join(" | ", run);
    }
}

package rigibo.lab.bench;

import rigibo.lab.bench.probe.Sample;
import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.bench.scene.Pace;
import rigibo.lab.child.Interval;
import rigibo.lab.child.Work;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.report.Amount;
import rigibo.lab.report.Report.Passage;
import rigibo.lab.report.Table;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/** The part of the report about one scene. */
final class SceneSection {

    private static final double MICRONS = 1e6;
    private static final double MILLIS = 1e3;

    private static final List<String> HEAD =
            List.of(
                    "engine",
                    "median",
                    "p99",
                    "in times of ours",
                    "aim",
                    "bytes a step",
                    "deepest overlap",
                    "height kept",
                    "energy kept");

    private final BenchScene scene;
    private final Results results;

    SceneSection(BenchScene scene, Results results) {
        this.scene = scene;
        this.results = results;
    }

    Passage passage() {
        return new Passage(scene.name(), scene.name(), what(), table(), sentences());
    }

    /** Describes the scene and says which steps were timed. */
    private String what() {
        Pace pace = scene.pace();
        String settling = pace.settling() == 0 ? "from the first on" : "after " + pace.settling();
        return scene.what() + "; " + pace.timed() + " steps timed, " + settling;
    }

    private Table table() {
        return new Table(HEAD, results.engines(scene.name()).stream().map(this::row).toList());
    }

    private List<String> row(String engine) {
        return List.of(
                engine,
                Amount.time(median(engine, Sample::median)),
                Amount.time(median(engine, Sample::p99)),
                isOurs(engine) ? "1" : ratio(engine),
                aim(engine),
                String.format(Locale.ROOT, "%,.0f", median(engine, Sample::bytes)),
                length(median(engine, Sample::overlap)),
                share(median(engine, Sample::height)),
                share(median(engine, Sample::energy)));
    }

    private double median(String engine, ToDoubleFunction<Sample> of) {
        return results.median(scene.name(), engine, of);
    }

    private static boolean isOurs(String engine) {
        return engine.equals(RigiBoEngine.NAME);
    }

    private String ratio(String engine) {
        return results.ratio(scene.name(), engine).map(SceneSection::spread).orElse("");
    }

    private static String spread(Interval ratio) {
        String median = Amount.digits(ratio.median());
        return ratio.low() == ratio.high()
                ? median
                : String.format(
                        "%s (%s to %s)",
                        median, Amount.digits(ratio.low()), Amount.digits(ratio.high()));
    }

    private String aim(String engine) {
        OptionalDouble aim = Aims.ratio(scene.name(), engine);
        return aim.isEmpty()
                ? ""
                : results.ratio(scene.name(), engine)
                        .map(ratio -> Aims.atLeast(aim.getAsDouble(), ratio.median()))
                        .orElse("");
    }

    private static String length(double metres) {
        return metres < 1e-3
                ? Amount.digits(metres * MICRONS) + " µm"
                : Amount.digits(metres * MILLIS) + " mm";
    }

    private static String share(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }

    /** The work, evenness and allocation of our steps; empty if it was not run. */
    private List<String> sentences() {
        List<Sample> ours = results.samples(scene.name(), RigiBoEngine.NAME);
        if (ours.isEmpty()) {
            return List.of();
        }
        List<String> sentences = new ArrayList<>();
        sentences.add(work(ours.get(0)));
        double unevenness =
                median(RigiBoEngine.NAME, Sample::p99) / median(RigiBoEngine.NAME, Sample::median);
        sentences.add(
                String.format(
                        "p99 is %s × the median (%s), and a step allocates %.0f bytes (%s).",
                        Amount.digits(unevenness),
                        Aims.atMost(Aims.P99, unevenness),
                        median(RigiBoEngine.NAME, Sample::bytes),
                        Aims.atMost(0, median(RigiBoEngine.NAME, Sample::bytes))));
        return sentences;
    }

    /** The work of an average timed step. */
    private static String work(Sample sample) {
        Work work = sample.work();
        double steps = sample.steps();
        return String.format(
                Locale.ROOT,
                "A step of ours: %,.0f pairs, %,.0f contacts, %,.0f rows, %,.1f impacts, %,.0f"
                        + " evaluations of a distance.",
                work.pairs() / steps,
                work.contacts() / steps,
                work.rows() / steps,
                work.impacts() / steps,
                work.evaluations() / steps);
    }
}

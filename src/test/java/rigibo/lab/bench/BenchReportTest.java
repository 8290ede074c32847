package rigibo.lab.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.lab.bench.probe.Sample;
import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.bench.scene.BenchScenes;
import rigibo.lab.child.Work;
import rigibo.lab.report.Report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Of two engines that took 1, 1.2 and 1.1 ms, and 2, 4.8 and 3.3 ms, for steps of large-pyramid.
 */
class BenchReportTest {

    private static final String SCENE = "large-pyramid";
    private static final String OURS = "RigiBo";
    private static final String PEER = "gdx-box2d 1.14.0";

    private final Results results = new Results(runs());

    private static List<Run> runs() {
        double[] ours = {1e6, 1.2e6, 1.1e6};
        double[] theirs = {2e6, 4.8e6, 3.3e6};
        List<Run> runs = new ArrayList<>();
        for (int i = 0; i < ours.length; i++) {
            runs.add(new Run(SCENE, OURS, i + 1, sample(ours[i], 1)));
            runs.add(new Run(SCENE, PEER, i + 1, sample(theirs[i], 0.7)));
        }
        // A time in proportion to the size, by ours alone at the largest.
        runs.add(new Run("flood-of-1000", OURS, 1, sample(1e6, 1)));
        runs.add(new Run("flood-of-1000", PEER, 1, sample(2e6, 1)));
        runs.add(new Run("flood-of-10000", OURS, 1, sample(10e6, 1)));
        runs.add(new Run("flood-of-10000", PEER, 1, sample(200e6, 1)));
        runs.add(new Run("flood-of-50000", OURS, 1, sample(50e6, 1)));
        return runs;
    }

    private static Sample sample(double nanos, double height) {
        Work work = new Work(120_000, 110_000, 0, 0, 480_000);
        return new Sample(10, nanos, 3 * nanos, 0, 4e-4, height, 0.98, work);
    }

    private Report report() {
        List<BenchScene> scenes = new ArrayList<>(List.of(BenchScenes.named(SCENE)));
        scenes.addAll(BenchScenes.sweep());
        return BenchReport.of(new Inquiry(scenes, List.of(), 3, Path.of("out")), results);
    }

    /** Ratios 2, 4 and 3. */
    @Test
    void ratiosAreOfTheSameRound() {
        var ratio = results.ratio(SCENE, PEER).orElseThrow();
        assertThat(ratio.median()).isCloseTo(3, within(1e-9));
        assertThat(ratio.low()).isCloseTo(2, within(1e-9));
        assertThat(ratio.high()).isCloseTo(4, within(1e-9));
        assertThat(results.median(SCENE, OURS, Sample::median)).isEqualTo(1.1e6);
    }

    @Test
    void tellsRatiosAimsAndWhatBecameOfTheScene() {
        String page = report().markdown("Measured somewhere.");
        assertThat(page)
                .startsWith("Measured somewhere.\n")
                .contains("### large-pyramid\n")
                .contains("| RigiBo | 1.10 ms | 3.30 ms | 1 |")
                .contains("| 3.30 ms | 9.90 ms | 3.00 (2.00 to 4.00) | ≥ 3: met | 0 |")
                .contains("| 400 µm | 0.700 | 0.980 |")
                .contains("12,000 pairs, 11,000 contacts, 48,000 rows")
                .contains("p99 is 3.00 × the median (≤ 2: not met)");
    }

    @Test
    void tellsTheExponentOfGrowth() {
        String page = report().markdown("");
        assertThat(page)
                .contains("### Growth\n")
                .contains("| 50,000 | 50.0 ms |  |")
                .contains("| exponent | 1.00 | 2.00 |")
                .contains("Our exponent is 1.00 (≤ 1.1: met)");
    }

    @Test
    void terminalShowsTheSameInColumns() {
        assertThat(report().text())
                .contains("sweep")
                .anyMatch(line -> line.startsWith("large-pyramid: 5,050 boxes"))
                .anyMatch(line -> line.matches("  RigiBo +1\\.10 ms +3\\.30 ms +1 .*"));
    }

    @Test
    void tableHasALineForEachSceneEngineAndRound() {
        List<String> lines = BenchCsv.lines(results.runs());
        assertThat(lines).hasSize(1 + 6 + 5);
        assertThat(lines.get(0)).startsWith("scene,engine,round,steps,median_ns,p99_ns,");
        assertThat(lines.get(4))
                .isEqualTo(
                        "large-pyramid,gdx-box2d 1.14.0,2,10,4800000.0,1.44E7,0.0,4.0E-4,0.7,0.98,"
                                + ",,,,");
        assertThat(lines.get(1)).endsWith(",120000,110000,0,0,480000");
    }

    @Test
    void aimsAreMetAtTheirEdge() {
        assertThat(Aims.atLeast(3, 3)).isEqualTo("≥ 3: met");
        assertThat(Aims.atMost(1.1, 1.11)).isEqualTo("≤ 1.1: not met");
        assertThat(Aims.ratio("pyramid", PEER)).isEmpty();
        assertThat(Aims.ratio("free", "JBox2D 2.2.1.1")).hasValue(25);
    }
}

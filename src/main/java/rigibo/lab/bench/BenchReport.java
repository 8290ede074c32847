package rigibo.lab.bench;

import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.bench.scene.BenchScenes;
import rigibo.lab.report.Report;
import rigibo.lab.report.Report.Passage;

import java.util.ArrayList;
import java.util.List;

/** The report of the bench, for a terminal and for a page. */
final class BenchReport {

    private BenchReport() {}

    static Report of(Inquiry inquiry, Results results) {
        List<Passage> passages = new ArrayList<>();
        for (BenchScene scene : inquiry.scenes()) {
            if (!BenchScenes.isSwept(scene.name())) {
                passages.add(new SceneSection(scene, results).passage());
            }
        }
        SweepSection sweep = new SweepSection(results);
        if (!sweep.isEmpty()) {
            passages.add(new Passage("sweep", "Growth", "", sweep.table(), sweep.sentences()));
        }
        return new Report(method(inquiry.rounds()), passages);
    }

    private static String method(int rounds) {
        return rounds == 1
                ? "One round."
                : String.format(
                        "Medians of %d rounds in which the engines took turns; in brackets the"
                                + " range of single rounds.",
                        rounds);
    }
}

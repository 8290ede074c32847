package rigibo.lab.bench;

import rigibo.lab.bench.scene.BenchScenes;
import rigibo.lab.report.Table;

import java.util.ArrayList;
import java.util.List;

/** What was found, for a terminal and for a page. */
final class BenchReport {

    private final List<SceneSection> scenes;
    private final SweepSection sweep;
    private final int rounds;

    BenchReport(Inquiry inquiry, Results results) {
        scenes =
                inquiry.scenes().stream()
                        .filter(scene -> !BenchScenes.isSwept(scene.name()))
                        .map(scene -> new SceneSection(scene, results))
                        .toList();
        sweep = new SweepSection(results);
        rounds = inquiry.rounds();
    }

    /** For a terminal. */
    List<String> text() {
        List<String> lines = new ArrayList<>();
        for (SceneSection scene : scenes) {
            lines.add(scene.title() + ": " + scene.what());
            tell(lines, scene.table(), scene.sentences());
        }
        if (!sweep.isEmpty()) {
            lines.add("sweep");
            tell(lines, sweep.table(), sweep.sentences());
        }
        return lines;
    }

    private static void tell(List<String> lines, Table table, List<String> sentences) {
        table.text().forEach(line -> lines.add("  " + line));
        sentences.forEach(sentence -> lines.add("  " + sentence));
        lines.add("");
    }

    /** The measured part of a page of Markdown. */
    String markdown(String provenance) {
        StringBuilder page = new StringBuilder();
        page.append(provenance).append("\n\n").append(method()).append("\n\n");
        for (SceneSection scene : scenes) {
            page.append("### ").append(scene.title()).append("\n\n");
            page.append(capital(scene.what())).append(".\n\n");
            tell(page, scene.table(), scene.sentences());
        }
        if (!sweep.isEmpty()) {
            page.append("### Growth\n\n");
            tell(page, sweep.table(), sweep.sentences());
        }
        return page.toString().stripTrailing() + "\n";
    }

    private String method() {
        return rounds == 1
                ? "One round."
                : String.format(
                        "Medians of %d rounds in which the engines took turns; in brackets between"
                                + " which ratios of single rounds they lie.",
                        rounds);
    }

    private static void tell(StringBuilder page, Table table, List<String> sentences) {
        page.append(table.markdown()).append("\n");
        sentences.forEach(sentence -> page.append(sentence).append("\n\n"));
    }

    private static String capital(String words) {
        return Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }
}

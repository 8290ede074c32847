package rigibo.web.build;

import rigibo.web.Times;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The times of a step in the page and on the JVM, as the table of docs/performance.md. */
final class TimesTable {

    private TimesTable() {}

    /** The time of a step of a scene, µs, and the state at the scene's end. */
    private record Step(String scene, double micros, String end) {

        static Step of(String line) {
            String[] words = line.substring(Times.MARK.length()).split("[: ]+");
            return new Step(words[0], Double.parseDouble(words[1]), words[2]);
        }

        static List<Step> all(List<String> lines) {
            return lines.stream().map(Step::of).toList();
        }
    }

    /** Measures the scenes one after the other and prints the table. */
    static void print(Browser browser, Path folder) throws IOException, InterruptedException {
        List<Step> here = Step.all(BitsCheck.onJvm(() -> Times.main(new String[0]), Times.MARK));
        List<Step> compiled = there(browser, folder, "lines.html?times");
        List<Step> script = there(browser, folder, "lines.html?times-script");
        List<String> rows = new ArrayList<>();
        for (int i = 0; i < here.size(); i++) {
            rows.add(row(here.get(i), compiled.get(i), script.get(i)));
        }
        System.out.println("| scene | JVM | WebAssembly | JavaScript | ends alike |");
        System.out.println("|---|---|---|---|---|");
        rows.forEach(System.out::println);
    }

    private static List<Step> there(Browser browser, Path folder, String page)
            throws IOException, InterruptedException {
        try (LocalServer server = new LocalServer(folder, 0)) {
            String said = browser.read(server, page);
            List<Step> steps = Step.all(BitsCheck.lines(said, Times.MARK));
            if (steps.size() != Times.SCENES.size()) {
                throw new IOException(page + " says: " + said);
            }
            return steps;
        }
    }

    private static String row(Step here, Step compiled, Step script) {
        return String.format(
                Locale.ROOT,
                "| `%s` | %.0f µs | %s | %s | %s |",
                here.scene,
                here.micros,
                beside(compiled, here),
                beside(script, here),
                compiled.end.equals(here.end) && script.end.equals(here.end)
                        ? "all"
                        : compiled.end.equals(here.end) ? "WebAssembly" : "none");
    }

    private static String beside(Step step, Step here) {
        return String.format(Locale.ROOT, "%.0f µs (%.1f)", step.micros, step.micros / here.micros);
    }
}

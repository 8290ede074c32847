package rigibo.web.build;

import rigibo.frontend.puzzle.level.Level;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * Measures the page in Chromium: pictures a second, its own work for a picture, and whether the
 * world keeps real time, with the whole processor and with a quarter of it. If WebGL runs on the
 * processor, pixels hide everything else. So each is measured with all pixels and with very few,
 * which leave all of the page's work, but none of the graphics card's.
 */
final class PaceTable {

    /** Time until a scene is warm, and time in which pictures are counted, ms. */
    private static final int WARMING = 6000;

    private static final int MEASURED = 10_000;

    /** Factors by which Chromium slows the page down. */
    private static final List<Integer> SLOWER = List.of(1, 4);

    /** Screen pixels for each pixel of the page: the usual number, and few. */
    private static final List<Double> RATIOS = List.of(1.0, 0.1);

    /** Script that records the work of each picture, ms, and integrates the share of real time. */
    private static final String COUNTING =
            "const ask = window.requestAnimationFrame.bind(window);"
                    + " window.works = []; window.real = 0; let last = performance.now();"
                    + " window.requestAnimationFrame = made => ask(at => {"
                    + " const begin = performance.now(); made(at); const end = performance.now();"
                    + " works.push(end - begin); real += (end - last) * rigiboPace(); last = end;"
                    + " });";

    /**
     * Script for pictures a second, the median and the 95th percentile of the work, ms, and the
     * pace.
     */
    private static final String COUNTED =
            "new Promise(done => setTimeout(() => {"
                    + " works.length = 0; real = 0; const begin = performance.now();"
                    + " setTimeout(() => {"
                    + " const count = works.length, took = performance.now() - begin;"
                    + " const sorted = works.sort((a, b) => a - b);"
                    + " done([1000 * count / took, sorted[count >> 1],"
                    + " sorted[Math.floor(0.95 * count)], 100 * real / took]"
                    + ".map(one => one.toFixed(1)).join(' ')); }, "
                    + MEASURED
                    + "); }, "
                    + WARMING
                    + "))";

    private PaceTable() {}

    /** Measures the scenes one after the other and prints the table. */
    static void print(Browser browser, Path folder) throws IOException, InterruptedException {
        Level most =
                PageCheck.levels().stream()
                        .max(Comparator.comparingInt(level -> level.bodies().size()))
                        .orElseThrow();
        System.out.println(
                "| scene | pixels | processor | pictures/s | work, p50 | p95 | real time |");
        System.out.println("|---|---|---|---|---|---|---|");
        for (String scene : List.of(most.id(), "flood?count=300")) {
            for (double ratio : RATIOS) {
                for (int slower : SLOWER) {
                    System.out.println(row(browser, folder, scene, ratio, slower));
                }
            }
        }
    }

    private static String row(Browser browser, Path folder, String scene, double ratio, int slower)
            throws IOException, InterruptedException {
        try (LocalServer server = new LocalServer(folder, 0);
                Browser.Window window = browser.open()) {
            DevTools page = new DevTools(window.port());
            page.size(MouseCheck.WIDTH, MouseCheck.HEIGHT, ratio);
            page.begin(COUNTING);
            page.send("Emulation.setCPUThrottlingRate", "\"rate\":" + slower);
            page.open(server.address("#" + scene));
            while (!page.value("window.rigiboPace ? 1 : 0").equals("1")) {
                Thread.sleep(100);
            }
            String[] counted = page.value(COUNTED).split(" ");
            page.close();
            return String.format(
                    Locale.ROOT,
                    "| `%s` | 1/%.0f | 1/%d | %s | %s ms | %s ms | %s %% |",
                    scene,
                    1 / (ratio * ratio),
                    slower,
                    counted[0],
                    counted[1],
                    counted[2],
                    counted[3]);
        }
    }
}

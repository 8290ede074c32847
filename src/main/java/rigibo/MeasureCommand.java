package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.DrawingTiming;
import rigibo.frontend.display.LoopTiming;
import rigibo.frontend.display.WindowTiming;
import rigibo.frontend.scene.Settings;
import rigibo.lab.FloodFriction;
import rigibo.lab.FloodTiming;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;

/** Measures the times that {@code docs/playing.md} states. */
@Command(
        name = "measure",
        description =
                "Times the start, changes of windows, the flood, drawing, and 600 turns of the loop"
                        + " with and without vsync.")
final class MeasureCommand implements Callable<Integer> {

    private static final int TURNS = 600;
    private static final int[] FLOODS = {1000, 2000, 5000};

    /** Bodies and their width in px: a full level, and the flood. */
    private static final int[][] PICTURES = {{50, 64}, {2000, 9}};

    @Spec private CommandSpec spec;

    @Override
    public Integer call() {
        PrintWriter out = spec.commandLine().getOut();
        // Comes first, since it counts from the start of the process; levels load as in play.
        CompletableFuture.runAsync(Catalog::entries);
        WindowTiming.Result windows = WindowTiming.measure(Catalog::menu, Catalog::entries);
        out.printf(
                "the menu is seen %.0f ms after the start; a change of windows: median %.0f ms, at"
                        + " most %.0f ms%n",
                windows.startMillis(), windows.medianMillis(), windows.mostMillis());
        for (int bodies : FLOODS) {
            FloodTiming flood = FloodTiming.measure(bodies);
            out.printf(
                    "flood of %d discs: median %.2f ms, p99 %.2f ms a step, overlap %.1f mm%n",
                    flood.bodies(),
                    flood.medianMillis(),
                    flood.p99Millis(),
                    1000 * flood.deepestOverlap());
        }
        FloodFriction friction = FloodFriction.measure();
        out.printf(
                "flood of 600 discs without friction: %.2f of a step with it (quartiles %.2f to"
                        + " %.2f), %d rows instead of %d%n",
                friction.ratio(),
                friction.lower(),
                friction.upper(),
                friction.rowsWithout(),
                friction.rows());
        for (int[] picture : PICTURES) {
            drawing(out, picture[0], picture[1], Settings.Detail.FULL);
            drawing(out, picture[0], picture[1], Settings.Detail.LITE);
        }
        for (boolean vsync : new boolean[] {true, false}) {
            double seconds = LoopTiming.seconds(Catalog::menu, TURNS, vsync);
            out.printf("%d turns %s vsync: %.3f s%n", TURNS, vsync ? "with" : "without", seconds);
        }
        return 0;
    }

    private static void drawing(PrintWriter out, int bodies, int pixels, Settings.Detail detail) {
        double[] millis = DrawingTiming.millis(bodies, pixels, detail);
        out.printf(
                "drawing %d bodies of %d px%s: median %.2f ms, p99 %.2f ms a frame%n",
                bodies,
                pixels,
                detail == Settings.Detail.LITE ? " in less detail" : "",
                millis[0],
                millis[1]);
    }
}

package rigibo.frontend.display;

import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;

/** Measures the time until something is visible: first for the menu, then for every scene. */
public final class WindowTiming implements Display.Companion {

    private final Supplier<List<SceneEntry>> scenes;
    private List<SceneEntry> entries = List.of();
    private double[] changes = {};
    private double startMillis = -1;
    private Scene left;
    private long asked;
    private int done;

    private WindowTiming(Supplier<List<SceneEntry>> scenes) {
        this.scenes = scenes;
    }

    /**
     * The measured times.
     *
     * @param startMillis from Java's start to the first picture of the menu, ms
     * @param medianMillis of all changes from the menu to a scene and back, from the wish to the
     *     first picture in the new window, ms
     * @param mostMillis of the longest of them, ms
     */
    public record Result(double startMillis, double medianMillis, double mostMillis) {}

    /**
     * Opens the menu, goes to every scene and back.
     *
     * @throws DisplayException when no window can be opened
     */
    public static Result measure(
            Function<Director, Scene> menu, Supplier<List<SceneEntry>> scenes) {
        WindowTiming timing = new WindowTiming(scenes);
        Display display = new Display(menu, true);
        display.accompany(timing);
        display.run(null);
        Arrays.sort(timing.changes);
        int count = timing.changes.length;
        return new Result(timing.startMillis, timing.changes[count / 2], timing.changes[count - 1]);
    }

    /** Lets each window make one turn, then asks for the next scene. */
    @Override
    public void beforeTurn(Display display, Scene scene) {
        boolean isSeen = startMillis >= 0 && left == null;
        if (isSeen && done == changes.length) {
            display.quit();
        } else if (isSeen) {
            left = scene;
            asked = System.nanoTime();
            if (done % 2 == 0) {
                display.show(entries.get(done / 2).open().apply(display));
            } else {
                display.showMenu();
            }
        }
    }

    @Override
    public void afterDrawing(Display display, Scene scene) {
        if (startMillis < 0) {
            // Corrects the system's start time of the process, which may be a second off.
            startMillis = ManagementFactory.getRuntimeMXBean().getUptime();
            entries = scenes.get();
            changes = new double[2 * entries.size()];
        } else if (left != null && scene != left) {
            changes[done++] = (System.nanoTime() - asked) / 1e6;
            left = null;
        }
    }
}

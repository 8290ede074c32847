package rigibo.frontend.display;

import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;

import java.util.function.Function;

/** Measures the time of some turns of the loop in a real window. */
public final class LoopTiming implements Display.Companion {

    private final int turns;
    private int turn;
    private long started;
    private long ended;

    private LoopTiming(int turns) {
        this.turns = turns;
    }

    /**
     * Runs a scene for some turns.
     *
     * @return the seconds they took
     * @throws DisplayException when no window can be opened
     */
    public static double seconds(Function<Director, Scene> scene, int turns, boolean vsync) {
        LoopTiming timing = new LoopTiming(turns);
        Display display = new Display(scene, vsync);
        display.accompany(timing);
        display.run(null);
        return (timing.ended - timing.started) / 1e9;
    }

    /** Counts from the second turn on: the first also opens the window. */
    @Override
    public void beforeTurn(Display display, Scene scene) {
        turn++;
        if (turn == 2) {
            started = System.nanoTime();
        }
        if (turn == turns + 2) {
            ended = System.nanoTime();
            display.quit();
        }
    }
}

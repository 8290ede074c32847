package rigibo.web;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.lab.bench.scene.MovingScenes;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.RigiBoEngine;

import java.util.Arrays;
import java.util.List;

/** Prints the time of a step in some scenes of the bench, on the JVM and in a browser. */
public final class Times {

    /** Beginning of all lines. */
    public static final String MARK = "times of ";

    /** A falling crowd, a pile that comes to rest, and chains of joints. */
    public static final List<String> SCENES = List.of("rain-mixed-200", "settle-20", "bridge");

    /** Steps of a run: 5 s. */
    private static final int STEPS = 300;

    /** Runs before the code is fully compiled, and runs of which the median is taken. */
    private static final int WARMING = 5;

    private static final int TIMED = 5;

    private static final double MICROSECOND = 1e3;

    private Times() {}

    /**
     * Prints a line for each scene: its name, the time of a step in µs, and the state at the end.
     */
    public static void main(String[] arguments) {
        for (String name : SCENES) {
            Run last = null;
            double[] micros = new double[TIMED];
            for (int run = -WARMING; run < TIMED; run++) {
                last = Run.of(name);
                if (run >= 0) {
                    micros[run] = last.nanos / MICROSECOND / STEPS;
                }
            }
            Arrays.sort(micros);
            System.out.println(
                    MARK + name + ": " + micros[TIMED / 2] + " " + Long.toHexString(last.state));
        }
    }

    /** A run of a scene: its time, ns, and the hash of its end. */
    private record Run(long nanos, long state) {

        static Run of(String name) {
            Scene scene = MovingScenes.named(name).scene().get();
            Pool pool = new Pool(scene.effects(), Accuracy.GAME);
            scene.build(RigiBoEngine.world(pool));
            long begin = System.nanoTime();
            for (int i = 0; i < STEPS; i++) {
                pool.step(Scene.STEP);
            }
            return new Run(System.nanoTime() - begin, pool.stateHash());
        }
    }
}

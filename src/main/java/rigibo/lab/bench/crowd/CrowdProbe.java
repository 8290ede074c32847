package rigibo.lab.bench.crowd;

import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.Flood;
import rigibo.lab.bench.probe.StepTimes;
import rigibo.lab.child.Fields;
import rigibo.lab.child.ThreadUse;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.World;

import java.util.Comparator;
import java.util.stream.IntStream;

/** The main class of a process that simulates one flood and prints the times of steps. */
public final class CrowdProbe {

    static final String MARK = "crowd ";

    private static final Flood TROUGH = new Flood(40, 0.25);
    private static final double NANOS_PER_MILLI = 1e6;

    /** The number of fixed bodies, the floor and the walls, which are added first. */
    private static final int WALLS = 3;

    private CrowdProbe() {}

    /**
     * Simulates the flood.
     *
     * @param arguments name of the engine, number of discs, steps before timing, steps timed
     */
    public static void main(String[] arguments) {
        Engine engine = Engines.named(arguments[0]);
        int discs = Integer.parseInt(arguments[1]);
        int warm = Integer.parseInt(arguments[2]);
        double[] millis = new double[Integer.parseInt(arguments[3])];
        try (World world = engine.world(Flood.FRICTIONLESS, Engines.usual(engine))) {
            for (BodyDefinition body : TROUGH.bodies(discs, 0)) {
                world.add(body);
            }
            for (int i = -warm; i < millis.length; i++) {
                long begun = ThreadUse.nanos();
                world.step(Flood.STEP);
                if (i >= 0) {
                    millis[i] = (ThreadUse.nanos() - begun) / NANOS_PER_MILLI;
                }
            }
            StepTimes times = new StepTimes(millis);
            CrowdPoint point =
                    new CrowdPoint(
                            engine.name(),
                            discs,
                            times.median(),
                            times.p99(),
                            deepest(world, discs) / TROUGH.radius());
            System.out.println(MARK + Fields.line(point));
        }
    }

    /** The deepest overlap of discs, or of a disc and the floor, by their positions, m. */
    private static double deepest(World world, int discs) {
        Integer[] byX =
                IntStream.range(WALLS, WALLS + discs)
                        .boxed()
                        .sorted(Comparator.comparingDouble(world::x))
                        .toArray(Integer[]::new);
        double width = 2 * TROUGH.radius();
        double deepest = 0;
        for (int i = 0; i < discs; i++) {
            deepest = Math.max(deepest, TROUGH.radius() - world.y(byX[i]));
            for (int j = i + 1; j < discs; j++) {
                double across = world.x(byX[j]) - world.x(byX[i]);
                if (across > width) {
                    break;
                }
                double up = world.y(byX[j]) - world.y(byX[i]);
                deepest = Math.max(deepest, width - Math.hypot(across, up));
            }
        }
        return deepest;
    }
}

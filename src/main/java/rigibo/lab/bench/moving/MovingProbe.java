package rigibo.lab.bench.moving;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.probe.DeepestOverlap;
import rigibo.lab.bench.probe.Look;
import rigibo.lab.bench.probe.Stage;
import rigibo.lab.bench.probe.StepMeter;
import rigibo.lab.bench.probe.StepTimes;
import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.bench.scene.Driver;
import rigibo.lab.bench.scene.MovingScenes;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.child.Fields;
import rigibo.lab.engine.LinkErrors;
import rigibo.lab.engine.World;

import java.util.Arrays;
import java.util.List;

/**
 * The main class of a process that runs one scene several times in one engine. The first run is
 * examined; the others are timed, step by step. Every run does the same, so the median of a step
 * over the runs is free of disturbances by the system.
 */
public final class MovingProbe {

    static final String MARK = "course ";

    /**
     * How long in ns a scene is repeated before it is timed; small scenes end long before Java has
     * compiled them.
     */
    private static final long WARM_UP = 3_000_000_000L;

    private final Contestant contestant;
    private final Scene scene;
    private final int steps;
    private final double[] contacts;
    private double deepest;
    private double left;
    private double gain;
    private double jointError;
    private int lastMoving = -1;

    private MovingProbe(Contestant contestant, Scene scene, int steps) {
        this.contestant = contestant;
        this.scene = scene;
        this.steps = steps;
        contacts = new double[steps];
    }

    /**
     * Prints the course.
     *
     * @param arguments names of scene, engine and setting, number of steps, number of timed runs
     */
    public static void main(String[] arguments) {
        BenchScene scene = MovingScenes.named(arguments[0]);
        Contestant contestant = new Contestant(arguments[1], arguments[2]);
        int steps = Integer.parseInt(arguments[3]);
        int runs = Integer.parseInt(arguments[4]);
        System.out.println(
                MARK + Fields.line(measure(contestant, scene.scene().get(), steps, runs)));
    }

    /** Runs the scene to examine it, then to warm up, then a number of times to time it. */
    static Course measure(Contestant contestant, Scene scene, int steps, int runs) {
        MovingProbe probe = new MovingProbe(contestant, scene, steps);
        probe.look();
        probe.warmUp();
        double[][] nanos = new double[steps][runs];
        double[] bytes = new double[steps];
        for (int run = 0; run < runs; run++) {
            System.gc();
            probe.time(run, nanos, bytes);
        }
        double[] medians = Arrays.stream(nanos).mapToDouble(MovingProbe::median).toArray();
        return new Course(
                medians,
                contestant.isOurs() ? probe.contacts : new double[0],
                probe.lastMoving,
                probe.deepest,
                probe.left,
                probe.gain,
                median(bytes),
                probe.jointError);
    }

    private static double median(double[] values) {
        return new StepTimes(values).median();
    }

    private void look() {
        boolean isDriven = !(scene.driver() instanceof Driver.None);
        try (Stage stage = contestant.stage(scene)) {
            World world = stage.world();
            LinkErrors joints = new LinkErrors(scene.bodies(), scene.links());
            double start = Look.at(scene, world).energy();
            for (int i = 0; i < steps; i++) {
                stage.drive();
                stage.step();
                contacts[i] = stage.lastStep().contacts();
                left = DeepestOverlap.inWidths(scene, world);
                deepest = Math.max(deepest, left);
                jointError = Math.max(jointError, joints.worst(world));
                double energy = Look.at(scene, world).energy();
                gain = isDriven ? Double.NaN : Math.max(gain, energy / start - 1);
                lastMoving = isStill(world) ? lastMoving : i;
            }
        }
    }

    private boolean isStill(World world) {
        List<BodyDefinition> bodies = scene.bodies();
        for (int i = 0; i < bodies.size(); i++) {
            boolean isAsked = bodies.get(i).type() == BodyType.DYNAMIC && i != scene.loss().body();
            if (isAsked && speed(world, i) > contestant.still()) {
                return false;
            }
        }
        return true;
    }

    private static double speed(World world, int body) {
        return Math.hypot(world.velocityX(body), world.velocityY(body));
    }

    private void warmUp() {
        double[][] nanos = new double[steps][1];
        double[] bytes = new double[steps];
        long begun = System.nanoTime();
        while (System.nanoTime() - begun < WARM_UP) {
            time(0, nanos, bytes);
        }
    }

    private void time(int run, double[][] nanos, double[] bytes) {
        StepMeter meter = new StepMeter();
        try (Stage stage = contestant.stage(scene)) {
            for (int i = 0; i < steps; i++) {
                stage.drive();
                meter.measure(stage);
                bytes[i] = meter.bytes();
                nanos[i][run] = meter.nanos();
            }
        }
    }
}

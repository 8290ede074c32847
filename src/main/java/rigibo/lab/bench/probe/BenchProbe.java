package rigibo.lab.bench.probe;

import rigibo.lab.bench.scene.Pace;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.child.Work;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.Setting;

/** Times the steps of one scene in one engine, and examines where the bodies end. */
public final class BenchProbe {

    /** The beginning of the line that holds a sample. */
    public static final String MARK = "sample ";

    private static final double NANOS_PER_SECOND = 1e9;

    /** The most runs of a rehearsal, after which all that a short scene calls is compiled. */
    private static final int MOST_REHEARSALS = 20;

    private final Engine engine;
    private final Setting setting;
    private final Scene scene;
    private final Pace pace;

    private BenchProbe(Engine engine, Scene scene, Pace pace) {
        this.engine = engine;
        this.setting = Engines.usual(engine);
        this.scene = scene;
        this.pace = pace;
    }

    /** Rehearses, settles and times a scene. */
    public static Sample measure(Engine engine, Scene scene, Pace pace) {
        BenchProbe probe = new BenchProbe(engine, scene, pace);
        probe.rehearse();
        return probe.time();
    }

    private void rehearse() {
        long begun = System.nanoTime();
        for (int run = 0; run < MOST_REHEARSALS && isRehearsing(begun); run++) {
            try (Stage stage = new Stage(engine, setting, scene)) {
                for (int i = 0; i < pace.settling() + pace.timed() && isRehearsing(begun); i++) {
                    stage.drive();
                    stage.step();
                }
            }
        }
    }

    private boolean isRehearsing(long begun) {
        return System.nanoTime() - begun < pace.rehearsal() * NANOS_PER_SECOND;
    }

    private Sample time() {
        try (Stage stage = new Stage(engine, setting, scene)) {
            Look before = Look.at(scene, stage.world());
            for (int i = 0; i < pace.settling(); i++) {
                stage.drive();
                stage.step();
            }
            // Collects the garbage of rehearsal and settling now rather than during a timed step.
            System.gc();
            double[] nanos = new double[pace.timed()];
            double[] bytes = new double[pace.timed()];
            StepMeter meter = new StepMeter();
            Work work = Work.NONE;
            for (int i = 0; i < pace.timed(); i++) {
                stage.drive();
                meter.measure(stage);
                nanos[i] = meter.nanos();
                bytes[i] = meter.bytes();
                work = work.plus(stage.lastStep());
            }
            Look after = Look.at(scene, stage.world());
            StepTimes times = new StepTimes(nanos);
            return new Sample(
                    pace.timed(),
                    times.median(),
                    times.p99(),
                    new StepTimes(bytes).median(),
                    DeepestOverlap.in(scene, stage.world()),
                    after.height() / before.height(),
                    after.energy() / before.energy(),
                    work);
        }
    }
}

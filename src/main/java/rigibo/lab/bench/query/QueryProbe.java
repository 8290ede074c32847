package rigibo.lab.bench.query;

import rigibo.backend.Pool;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.bench.probe.StepTimes;
import rigibo.lab.child.Fields;
import rigibo.lab.child.ThreadUse;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;

import java.util.Random;

/** The main class of a process that times rays of every kind in one engine, and sensors in ours. */
public final class QueryProbe {

    static final String MARK = "answers ";

    /** The number of discs that rays may hit, and of rays of each kind. */
    static final int DISCS = 10_000;

    static final int RAYS = 10_000;

    /** The number of sensors, and of bodies that may be inside them. */
    static final int SENSORS = 1000;

    static final int VISITORS = 2000;

    private static final Effects TOUCHING = Effects.of(new Contacts());

    /** The spacing of the discs and their radius, m. The mean free path of a ray is 20 m. */
    private static final double APART = 3;

    private static final double RADIUS = 0.225;
    private static final double STEP = 1.0 / 60;

    /** The runs before the timed ones, until all code is compiled. */
    private static final int WARM = 5;

    /** The number of steps of a run with sensors. */
    private static final int STEPS = 60;

    private QueryProbe() {}

    /**
     * Prints the measurements.
     *
     * @param arguments names of engine and setting, number of runs
     */
    public static void main(String[] arguments) {
        Engine engine = Engines.named(arguments[0]);
        int runs = Integer.parseInt(arguments[2]);
        boolean isOurs = arguments[0].equals(RigiBoEngine.NAME);
        try (World world = engine.world(TOUCHING, Engines.setting(engine, arguments[1]))) {
            Answers rays = rays(world, runs);
            double sensing = isOurs ? sensing(runs) : 0;
            System.out.println(MARK + Fields.line(new Answers(rays.nanos(), rays.met(), sensing)));
        }
    }

    /** Fills a world with discs and casts rays in it. */
    static Answers rays(World world, int runs) {
        int side = (int) Math.sqrt(DISCS);
        Random random = new Random(1);
        for (int i = 0; i < DISCS; i++) {
            double x = (i % side - side / 2 + random.nextDouble()) * APART;
            double y = (i / side - side / 2 + random.nextDouble()) * APART;
            world.add(BodyDefinition.dynamic(new Circle(RADIUS)).at(x, y));
        }
        world.step(STEP);
        Rays[] kinds = Rays.values();
        double[] nanos = new double[kinds.length];
        double[] met = new double[kinds.length];
        for (Rays kind : kinds) {
            double[] rays = kind.draw(kind.ordinal(), RAYS, side * APART);
            double[] times = new double[runs];
            for (int run = -WARM; run < runs; run++) {
                long begun = ThreadUse.nanos();
                double sum = ask(world, rays);
                long taken = ThreadUse.nanos() - begun;
                times[Math.max(0, run)] = (double) taken / RAYS;
                met[kind.ordinal()] = sum / RAYS;
            }
            nanos[kind.ordinal()] = new StepTimes(times).median();
        }
        return new Answers(nanos, met, 0);
    }

    private static double ask(World world, double[] rays) {
        double sum = 0;
        for (int at = 0; at < rays.length; at += Rays.STRIDE) {
            sum += world.rayCast(rays[at], rays[at + 1], rays[at + 2], rays[at + 3]);
        }
        return sum;
    }

    /** The median step with sensors minus the median step without, ns. */
    private static double sensing(int runs) {
        double[] with = new double[(WARM + runs) * STEPS];
        double[] without = new double[(WARM + runs) * STEPS];
        for (int run = 0; run < WARM + runs; run++) {
            time(true, with, run * STEPS);
            time(false, without, run * STEPS);
        }
        return medianOfLast(with, runs) - medianOfLast(without, runs);
    }

    private static double medianOfLast(double[] times, int runs) {
        double[] last = new double[runs * STEPS];
        System.arraycopy(times, times.length - last.length, last, 0, last.length);
        return new StepTimes(last).median();
    }

    private static void time(boolean senses, double[] times, int from) {
        Pool pool = drifting(senses);
        for (int i = 0; i < STEPS; i++) {
            long begun = ThreadUse.nanos();
            pool.step(STEP);
            times[from + i] = ThreadUse.nanos() - begun;
        }
    }

    /** A pool of discs that drift among sensors; about a twentieth of them is inside one. */
    private static Pool drifting(boolean senses) {
        Pool pool = new Pool(senses ? TOUCHING.with(new Sensors()) : TOUCHING, Accuracy.GAME);
        Random random = new Random(2);
        double square = Math.sqrt(VISITORS) * APART;
        for (int i = 0; i < VISITORS; i++) {
            pool.add(
                    BodyDefinition.dynamic(new Circle(RADIUS))
                            .at(random.nextDouble() * square, random.nextDouble() * square)
                            .velocity(random.nextGaussian(), random.nextGaussian()));
        }
        for (int i = 0; senses && i < SENSORS; i++) {
            pool.add(
                    BodyDefinition.fixed(new Circle(RADIUS))
                            .sensor()
                            .at(random.nextDouble() * square, random.nextDouble() * square));
        }
        return pool;
    }
}

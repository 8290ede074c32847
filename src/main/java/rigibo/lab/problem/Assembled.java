package rigibo.lab.problem;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.Link;
import rigibo.lab.engine.LinkErrors;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Pendulum;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * R17 to R19: few joined bodies whose motion is known in closed form. A bar on a hinge swings at
 * the period of {@link Pendulum}; links that carry a load neither stretch nor gain energy; a mass
 * hangs on a spring at mg/k and oscillates about it as a damped cosine.
 */
final class Assembled {

    private static final List<Line> KNOBS = List.of(Line.STEP, Line.SUBSTEPS);

    private static final Effects SPACE = Effects.of(new Contacts(), new Rotation(), new Joints());
    private static final Effects EARTH = SPACE.with(new Gravity(0, -Earth.GRAVITY));

    /** A fixed body that collides with nothing. */
    private static final BodyDefinition HOOK = BodyDefinition.fixed(new Circle(0.01)).group(1);

    /**
     * Frequencies of springs that oscillate freely and are examined step by step, and of stiff ones
     * that are examined at rest, Hz.
     */
    private static final double[] SOFT = {2, 10, 15};

    private static final double[] STIFF = {200, 2000};

    /** Speed at the start by frequency, m: the amplitude is 2π times less. */
    private static final double AWAY = 0.2;

    private Assembled() {}

    /** The error promised at EXACT, row J1: 1e-6 of a period, in 100 of them. */
    static Problem pendulum() {
        return new Problem(
                "R17",
                "a pendulum that swings 100 times from 90°",
                "phase after 100 swings, rad",
                2 * Math.PI * 100 * 1e-6,
                KNOBS,
                Assembled::swing);
    }

    /** The error promised at EXACT is that of row J5. */
    static Problem chain() {
        return new Problem(
                "R18",
                "30 links with 10,000 times their mass at the end, let swing",
                "stretch / length",
                1e-6,
                KNOBS,
                Assembled::carry);
    }

    /** The error promised at EXACT is that of row J8. */
    static Problem springs() {
        return new Problem(
                "R19",
                "masses on springs of 2 to 2,000 Hz",
                "off the closed form / amplitude or sag",
                1e-4,
                KNOBS,
                Assembled::spring);
    }

    private static World build(Bench bench, Scene scene) {
        World world = bench.world(scene.effects());
        scene.build(world);
        return world;
    }

    private static Trial swing(Bench bench) {
        double d = 0.5;
        BodyDefinition bar = Solid.box(0.1, 1).at(d, 0).angle(Math.PI / 2).group(1);
        Scene scene = new Scene(EARTH, List.of(HOOK, bar), List.of(Link.hinge(0, 1, 0, 0)));
        World world = build(bench, scene);
        double mass = bar.massProperties().mass();
        double inertia = bar.massProperties().inertia() + mass * d * d;
        double period = Pendulum.period(inertia / (mass * d), Math.PI / 2);
        return () -> {
            LinkErrors joints = new LinkErrors(scene.bodies(), scene.links());
            double off = 0;
            double gain = 0;
            double last = 0;
            int crossings = 0;
            int swings = 100;
            int steps = bench.stepsIn((swings + 2) * period);
            for (int step = 0; step < steps && crossings < 2 * swings; step++) {
                double from = lag(world);
                double rate = turn(world) * bench.step();
                bench.step(world);
                double to = lag(world);
                if (from * to < 0) {
                    double rateTo = turn(world) * bench.step();
                    last = (step + Pendulum.crossing(from, rate, to, rateTo)) * bench.step();
                    crossings++;
                }
                if (bench.isCounting()) {
                    off = Math.max(off, joints.worst(world));
                    gain = Math.max(gain, Math.abs(energy(world, scene.bodies())) / (mass * d));
                }
            }
            if (bench.isCounting() && crossings < 2 * swings) {
                return Errors.failed("it swung " + crossings / 2 + " times");
            }
            // It passes the lowest point a quarter period after the start, then every half period.
            double truth = (crossings - 0.5) * period / 2;
            return Errors.of(Math.abs(last - truth) / period * 2 * Math.PI)
                    .with("largest change of energy, of its own", gain / Earth.GRAVITY)
                    .with("error of the joint, m", off);
        };
    }

    /** Angle of the line from the hinge to the body, measured from straight down, rad. */
    private static double lag(World world) {
        return Math.atan2(world.x(1), -world.y(1));
    }

    private static double turn(World world) {
        double x = world.x(1);
        double y = world.y(1);
        return (x * world.velocityY(1) - y * world.velocityX(1)) / (x * x + y * y);
    }

    private static Trial carry(Bench bench) {
        int links = 30;
        double length = 0.2;
        double angle = 1;
        double dx = length * Math.sin(angle);
        double dy = -length * Math.cos(angle);
        List<BodyDefinition> bodies = new ArrayList<>(List.of(HOOK));
        List<Link> joints = new ArrayList<>();
        BodyDefinition link = Solid.box(0.05, length).angle(angle).mass(1).group(1);
        for (int i = 0; i < links; i++) {
            bodies.add(link.at((i + 0.5) * dx, (i + 0.5) * dy));
            joints.add(Link.hinge(i, i + 1, i * dx, i * dy));
        }
        BodyDefinition bob = Solid.disc(length).mass(1e4).group(1);
        bodies.add(bob.at(links * dx, links * dy));
        joints.add(Link.hinge(links, links + 1, links * dx, links * dy));
        Scene scene = new Scene(EARTH, bodies, joints);
        World world = build(bench, scene);
        return () -> {
            LinkErrors errors = new LinkErrors(bodies, joints);
            double stretch = 0;
            double off = 0;
            double gain = 0;
            double start = 0;
            int steps = bench.stepsIn(5);
            for (int step = 0; step < steps; step++) {
                bench.step(world);
                if (bench.isCounting()) {
                    double reach = Math.hypot(world.x(links + 1), world.y(links + 1));
                    stretch = Math.max(stretch, reach / (links * length) - 1);
                    off = Math.max(off, errors.worst(world));
                    double energy = energy(world, bodies);
                    start = step == 0 ? energy : start;
                    gain = Math.max(gain, energy - start);
                }
            }
            double own = 1e4 * Earth.GRAVITY * links * length * (1 - Math.cos(angle));
            return Errors.of(stretch)
                    .with("energy gained, of its own", gain / own)
                    .with("error of the joints, m", off);
        };
    }

    /** Kinetic energy, and potential energy above the hook, which is the first body, J. */
    private static double energy(World world, List<BodyDefinition> bodies) {
        double sum = 0;
        for (int i = 1; i < bodies.size(); i++) {
            double mass = bodies.get(i).massProperties().mass();
            double vx = world.velocityX(i);
            double vy = world.velocityY(i);
            double spin = world.spin(i);
            double inertia = bodies.get(i).massProperties().inertia();
            sum += (mass * (vx * vx + vy * vy) + inertia * spin * spin) / 2;
            sum += mass * Earth.GRAVITY * world.y(i);
        }
        return sum;
    }

    private static Trial spring(Bench bench) {
        List<World> swinging = new ArrayList<>();
        List<World> loaded = new ArrayList<>();
        BodyDefinition mass = Solid.disc(0.2).mass(2).group(1);
        for (double hertz : SOFT) {
            List<Link> joints = List.of(Link.rod(0, 0, 0, 1, 1, 0).spring(hertz, 0));
            List<BodyDefinition> bodies = List.of(HOOK, mass.at(1, 0).velocity(AWAY * hertz, 0));
            swinging.add(build(bench, new Scene(SPACE, bodies, joints)));
        }
        for (double hertz : STIFF) {
            List<Link> joints = List.of(Link.rod(0, 0, 0, 1, 0, -1).spring(hertz, 0.7));
            loaded.add(build(bench, new Scene(EARTH, List.of(HOOK, mass.at(0, -1)), joints)));
        }
        return () -> {
            double[] off = new double[SOFT.length];
            for (int i = 0; i < SOFT.length; i++) {
                off[i] = swing(bench, swinging.get(i), SOFT[i]);
            }
            double[] sag = new double[STIFF.length];
            for (int i = 0; i < STIFF.length; i++) {
                sag[i] = hang(bench, loaded.get(i), STIFF[i]);
            }
            double swings = Mean.of(off);
            double hangs = Mean.of(sag);
            return Errors.of(Math.max(swings, hangs))
                    .with("period, relative", swings)
                    .with("deflection, of mg/k", hangs);
        };
    }

    /** The largest error of its phase in 2 s, as a share of it. */
    private static double swing(Bench bench, World world, double hertz) {
        double omega = 2 * Math.PI * hertz;
        double amplitude = AWAY / (2 * Math.PI);
        double worst = 0;
        int steps = bench.stepsIn(2);
        for (int step = 1; step <= steps; step++) {
            bench.step(world);
            double phase = omega * step * bench.step();
            double off = Math.abs(world.x(1) - 1 - amplitude * Math.sin(phase)) / amplitude;
            worst = Math.max(worst, off / Math.max(1, phase));
        }
        return worst;
    }

    /** The error of its height after 5 s, as a share of mg/k = g/ω², whatever the mass. */
    private static double hang(Bench bench, World world, double hertz) {
        double omega = 2 * Math.PI * hertz;
        int steps = bench.stepsIn(5);
        for (int step = 0; step < steps; step++) {
            bench.step(world);
        }
        double sag = Earth.GRAVITY / (omega * omega);
        return Math.abs((-1 - world.y(1)) / sag - 1);
    }
}

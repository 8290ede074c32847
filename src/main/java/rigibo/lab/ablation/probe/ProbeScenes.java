package rigibo.lab.ablation.probe;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** The scenes that are measured. */
final class ProbeScenes {

    private static final Effects WEIGHT = Effects.of(new Gravity(0, -9.81));
    private static final Effects TOUCHING = WEIGHT.with(new Contacts());
    private static final Effects RUBBING = TOUCHING.with(new Rotation()).with(new Friction());

    /** Inner width and height of a trough, m. */
    private static final double WIDTH = 20;

    private static final double HEIGHT = 100;
    private static final int WHEELS = 20;

    private ProbeScenes() {}

    /** A stack that falls asleep, beside a pyramid that a heavy crate hits. */
    static Workload crate() {
        String words =
                "a stack of 10 that falls asleep, a pyramid of 15 struck by a crate of ten times"
                        + " the mass";
        Effects usual = Effects.usual();
        return new Workload("crate", words, usual, ProbeScenes::crates, 0, 120, Workload.UNDRIVEN);
    }

    private static List<BodyDefinition> crates() {
        double size = 0.6;
        int base = 5;
        List<BodyDefinition> bodies = new ArrayList<>();
        BodyDefinition ground = BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5);
        bodies.add(ground.material(new Material(1, 0.6, 0)));
        BodyDefinition crate =
                BodyDefinition.dynamic(Polygon.box(size, size)).material(new Material(1, 0.5, 0.1));
        for (int i = 0; i < 10; i++) {
            bodies.add(crate.at(-12, (i + 0.5) * size));
        }
        for (int row = 0; row < base; row++) {
            for (int i = 0; i < base - row; i++) {
                double x = 6 + (i - (base - row - 1) / 2.0) * 1.04 * size;
                bodies.add(crate.at(x, (row + 0.5) * size));
            }
        }
        bodies.add(crate.at(-2, (1 + 0.5) * size).mass(10 * size * size).velocity(11, 2));
        return bodies;
    }

    /** Wheels that roll down a ramp each, driven by a torque and braked by a thrust. */
    static Workload wheel() {
        Effects effects =
                RUBBING.with(new RollingResistance())
                        .with(new Thrust())
                        .with(new ContinuousImpacts());
        String words = "20 wheels rolling down a ramp each under torque and thrust";
        return new Workload(
                "wheel", words, effects, ProbeScenes::wheels, 5, 90, ProbeScenes::driveWheels);
    }

    /** The wheels come first, so that they have the numbers from 0 on. */
    private static List<BodyDefinition> wheels() {
        double radius = 0.45;
        double slope = -Math.toRadians(15);
        // Distance between a ramp and the next below it, m.
        double storey = 12;
        Material rubber = new Material(1, 0.6, 0).rollingResistance(0.005);
        double along = -3.4;
        double above = 0.3 + radius;
        double x = along * Math.cos(slope) - above * Math.sin(slope);
        double y = along * Math.sin(slope) + above * Math.cos(slope);
        BodyDefinition wheel = BodyDefinition.dynamic(new Circle(radius)).mass(10).material(rubber);
        BodyDefinition ramp =
                BodyDefinition.fixed(Polygon.box(30, 0.6))
                        .angle(slope)
                        .material(rubber.rollingResistance(0));
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int i = 0; i < WHEELS; i++) {
            bodies.add(wheel.at(x, y - storey * i));
        }
        for (int i = 0; i < WHEELS; i++) {
            bodies.add(ramp.at(0, -storey * i));
        }
        return bodies;
    }

    private static void driveWheels(Pool pool) {
        for (int i = 0; i < WHEELS; i++) {
            RigidBody wheel = pool.bodies().get(i);
            wheel.applyTorque(-5);
            wheel.applyForce(-10, 0, wheel.x(), wheel.y());
        }
    }

    /** Boxes on lanes for half a second, in which rubber does not stop a box from 5 m/s. */
    static Workload friction() {
        String words = "60 boxes sliding on lanes of ice, wood and rubber";
        return new Workload(
                "friction", words, RUBBING, ProbeScenes::lanes, 2, 30, Workload.UNDRIVEN);
    }

    /** Boxes that slide, too far apart to meet. */
    private static List<BodyDefinition> lanes() {
        double[] lanes = {0.03, 0.4, 0.9};
        int boxes = 20;
        double halfHeight = 0.3;
        // Distance between boxes, m: more than the fastest slides in a period.
        double distance = 10;
        double length = (boxes + 2) * distance;
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int lane = 0; lane < lanes.length; lane++) {
            Material matter = new Material(1, lanes[lane], 0);
            double floor = -4.0 * lane;
            bodies.add(
                    BodyDefinition.fixed(Polygon.box(length, 1))
                            .at(length / 2 - distance, floor - 0.5)
                            .material(matter));
            BodyDefinition box =
                    BodyDefinition.dynamic(Polygon.box(0.9, 2 * halfHeight))
                            .velocity(5, 0)
                            .material(matter);
            for (int i = 0; i < boxes; i++) {
                bodies.add(box.at(distance * i, floor + halfHeight));
            }
        }
        return bodies;
    }

    /** Discs poured into a trough, without friction and without rotation. */
    static Workload flood(long seed) {
        Effects effects = TOUCHING.with(new Restitution()).with(new ContinuousImpacts());
        String words = "600 discs of r = 0.25 m and elasticity 0.5 falling into a trough";
        return new Workload("flood", words, effects, () -> drops(seed), 45, 60, Workload.UNDRIVEN);
    }

    private static List<BodyDefinition> drops(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<BodyDefinition> bodies = trough();
        BodyDefinition drop =
                BodyDefinition.dynamic(new Circle(0.25)).material(new Material(1, 0, 0.5));
        for (int i = 0; i < 600; i++) {
            double x = -WIDTH / 2 + 0.5 + (i % 30) * 0.65 + 0.1 * random.nextDouble();
            bodies.add(drop.at(x, 1 + (i / 30) * 0.6));
        }
        return bodies;
    }

    /** A floor at y = 0 and two walls, in a list that can be extended. */
    private static List<BodyDefinition> trough() {
        List<BodyDefinition> parts = new ArrayList<>();
        parts.add(BodyDefinition.fixed(Polygon.box(WIDTH + 2, 1)).at(0, -0.5));
        for (int side : new int[] {-1, 1}) {
            parts.add(
                    BodyDefinition.fixed(Polygon.box(1, HEIGHT))
                            .at(side * (WIDTH + 1) / 2, HEIGHT / 2 - 1));
        }
        return parts;
    }

    static Workload flyers(long seed) {
        String words = "20,000 discs in free flight";
        return new Workload("flyers", words, WEIGHT, () -> thrown(seed), 0, 30, Workload.UNDRIVEN);
    }

    private static List<BodyDefinition> thrown(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<BodyDefinition> bodies = new ArrayList<>();
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.3));
        for (int i = 0; i < 20_000; i++) {
            bodies.add(
                    disc.at(i % 200, i / 200)
                            .velocity(random.nextDouble() - 0.5, 5 * random.nextDouble()));
        }
        return bodies;
    }

    /** Boxes that begin in the air: put back into a heap they would lack their loads. */
    static Workload heap(long seed) {
        String words = "500 boxes tumbling onto a heap, sleep off";
        return new Workload("heap", words, RUBBING, () -> tumbling(seed), 0, 60, Workload.UNDRIVEN);
    }

    private static List<BodyDefinition> tumbling(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<BodyDefinition> bodies = trough();
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(0.5, 0.5));
        for (int i = 0; i < 500; i++) {
            double x = -WIDTH / 2 + 0.5 + (i % 20) * 0.98 + 0.1 * random.nextDouble();
            bodies.add(box.at(x, 0.6 + (i / 20) * 0.75).angle(random.nextDouble()));
        }
        return bodies;
    }

    /**
     * Discs side by side that never meet, each of which may use an effect, for a second and a half,
     * long enough to fall asleep.
     */
    static Workload row() {
        String words = "1,000 discs in a row, 3 m apart";
        return new Workload("flyers", words, WEIGHT, ProbeScenes::inARow, 0, 90, Workload.UNDRIVEN);
    }

    private static List<BodyDefinition> inARow() {
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int i = 0; i < 1000; i++) {
            bodies.add(BodyDefinition.dynamic(new Circle(0.3)).at(3.0 * i, 0));
        }
        return bodies;
    }
}

package rigibo.lab.problem;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Slope;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** The game's four demos, with what a player does in them first. */
final class DemoScenes {

    private static final Gravity GRAVITY = new Gravity(0, -Earth.GRAVITY);
    private static final long SEED = 7;

    /** Looks in 1.2 s: the box has tipped, the crate tumbles, the wheel rolls, boxes stand. */
    private static final int LONG = 36;

    /**
     * Looks in 0.57 s: drops bounce and meet. Then one lands on resting ones. There initial errors
     * grow a thousandfold, and the length of the step matters: EXACT is 7 mm off at 1/60 s, 2 mm at
     * 1/120 s and 30 nm at 1/240 s.
     */
    private static final int SHORT = 17;

    private DemoScenes() {}

    static List<DemoScene> all() {
        return List.of(crate(), wheel(), friction(), flood());
    }

    /** A stack of ten, a box that tips from its ledge, a crate that is flung and tumbles. */
    private static DemoScene crate() {
        double size = 0.6;
        BodyDefinition crate = Solid.box(size, size, 0.5, 0.1).mass(1);
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            bodies.add(crate.at(2.4, (i + 0.5) * size));
        }
        bodies.add(Solid.box(1, 0.5).at(5.3, 1.45));
        bodies.add(crate.at(-4, 1.5).angle(0.3).velocity(3, 1).spin(-2));
        bodies.add(Solid.fixed(24, 1, 0.6, 0).at(2, -0.5));
        bodies.add(Solid.fixed(1.6, 1.2).at(6.2, 0.6));
        return new DemoScene("crate", LONG, Effects.usual(), 0, bodies);
    }

    /** A wheel that lands on the ramp spinning, slips until it rolls, and is pushed up. */
    private static DemoScene wheel() {
        double radius = 0.45;
        Material rubber = new Material(1, 0.6, 0);
        Slope ramp = new Slope(Math.toRadians(15));
        BodyDefinition wheel =
                Solid.disc(radius).mass(10).spin(20).material(rubber.rollingResistance(0.005));
        Effects effects =
                Effects.of(
                        GRAVITY,
                        new Contacts(),
                        new Rotation(),
                        new Friction(),
                        new RollingResistance(),
                        new Thrust(),
                        new ContinuousImpacts());
        List<BodyDefinition> bodies = List.of(ramp.place(wheel, radius + 0.3), ramp.plank(rubber));
        return new DemoScene("wheel", LONG, effects, -10, bodies);
    }

    /** Boxes launched along lanes of ice, wood and rubber. */
    private static DemoScene friction() {
        double[] lanes = {0.03, 0.4, 0.9};
        double halfHeight = 0.3;
        List<BodyDefinition> bodies = new ArrayList<>();
        List<BodyDefinition> floors = new ArrayList<>();
        for (int lane = 0; lane < lanes.length; lane++) {
            Material matter = new Material(1, lanes[lane], 0);
            double y = -3.0 * lane;
            bodies.add(
                    Solid.box(0.9, 2 * halfHeight)
                            .at(0, y + halfHeight)
                            .velocity(5, 0)
                            .mass(10)
                            .material(matter));
            floors.add(Solid.fixed(40, 0.4).at(0, y - 0.2).material(matter));
        }
        bodies.addAll(floors);
        Effects effects = Effects.of(GRAVITY, new Contacts(), new Rotation(), new Friction());
        return new DemoScene("friction", LONG, effects, 0, bodies);
    }

    /** Drops poured into a trough, and the ball that bounces beside it. */
    private static DemoScene flood() {
        Material stone = new Material(1, 0.4, 0);
        Material drop = new Material(1, 0.4, 0.5);
        SplittableRandom random = new SplittableRandom(SEED);
        List<BodyDefinition> bodies = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            double x = -3.6 + 0.5 * (i % 15) + 0.2 * random.nextDouble();
            double y = 3 + 0.6 * (i / 15) + 0.3 * random.nextDouble();
            bodies.add(Solid.disc(0.14).at(x, y).velocity(0, -6).material(drop));
        }
        bodies.add(Solid.disc(0.4).at(6, 4.4).material(drop));
        bodies.add(Solid.fixed(24, 1).at(0, -0.5).material(stone));
        for (int side = -1; side <= 1; side += 2) {
            bodies.add(Solid.fixed(0.6, 20).at(side * 4.3, 10).material(stone));
        }
        Effects effects =
                Effects.of(GRAVITY, new Contacts(), new Restitution(), new ContinuousImpacts());
        return new DemoScene("flood", SHORT, effects, 0, bodies);
    }
}

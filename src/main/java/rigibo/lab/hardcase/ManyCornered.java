package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Slope;

/**
 * Regular polygons and a disc of 1 m start rolling down 10° at 1 m/s. Truth: when the next corner
 * lands, at the angle α = 2π/n, the angular momentum about it leaves ω′/ω = (½ + cos α)/(½ + 1), so
 * the energy falls by 2α²/3 a corner and by 2α/3r a metre: less with more corners. From this the
 * way covered while the disc rolls 5 m is 1.5 % behind the disc's at 256 corners and r = 1 m,
 * within the 2 % asked for; it would be 2.9 % at r = ½ m.
 */
final class ManyCornered implements HardCase {

    private static final double RADIUS = 1;
    private static final double ANGLE = Math.toRadians(10);
    private static final double SPEED = 1;
    private static final double WAY = 5;

    /** What a phase of the rolling edge may move the comparison of two ways, as a share. */
    private static final double LEEWAY = 1e-3;

    @Override
    public String row() {
        return "37";
    }

    @Override
    public String title() {
        return "the more corners a wheel has, the more it rolls like a disc";
    }

    /** One substep a step is too few for what turns on a corner. */
    @Override
    public Preset limitedFrom() {
        return Preset.GAME;
    }

    @Override
    public String finding() {
        return "By the impacts of its corners alone a wheel of 256 is 1.5 % behind, so 2 % leaves"
                + " half a percent. At 3.4 m/s a corner lands 2.3 times a step; at GAME it lands"
                + " within 0.1 mm of the slope, and what it falls through costs the rest."
                + " At EXACT the wheel of 16 corners has a little more energy after ten steps than"
                + " it began with.";
    }

    @Override
    public void run(Trial trial) {
        double disc = way(trial, new Circle(RADIUS));
        double before = 0;
        for (int corners : new int[] {16, 64, 256}) {
            trial.variant(corners + " corners");
            double way = way(trial, Polygon.regular(corners, RADIUS)) / disc;
            trial.require("rolls farther than with fewer corners", way > before);
            trial.require("rolls no farther than the disc", way < 1 + LEEWAY);
            before = way;
        }
        trial.measure("behind the disc at 256 corners", 1 - before, "of way", 2e-2);
    }

    private static double way(Trial trial, Shape shape) {
        Slope slope = new Slope(ANGLE);
        WatchedPool pool = trial.pool(Surroundings.earth());
        pool.add(slope.plank(Surroundings.matter(0.8, 0)));
        BodyDefinition wheel =
                slope.place(
                                BodyDefinition.dynamic(shape).material(Surroundings.matter(0.8, 0)),
                                RADIUS)
                        .velocity(SPEED * Math.cos(ANGLE), -SPEED * Math.sin(ANGLE))
                        .spin(-SPEED / RADIUS);
        RigidBody body = pool.add(wheel);
        double startX = body.x();
        double startY = body.y();
        double a = 2 * Trial.GRAVITY * Math.sin(ANGLE) / 3;
        pool.run((Math.sqrt(SPEED * SPEED + 2 * a * WAY) - SPEED) / a);
        return slope.down(body.x() - startX, body.y() - startY);
    }
}

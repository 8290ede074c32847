package rigibo.lab.hardcase;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Slope;
import rigibo.lab.truth.Solid;

/**
 * Regular polygons and a disc of 1 m start rolling down 10° at 1 m/s. Truth: when the next corner
 * lands, at the angle α = 2π/n, the angular momentum about it gives ω′/ω = (½ + cos α)/(½ + 1). The
 * energy falls by 2α²/3 a corner and by 2α/3r a metre: less with more corners. So while the disc
 * rolls 5 m, the way of 256 corners is 1.5 % shorter at r = 1 m, within the 2 % asked for; at r = ½
 * m it would be 2.9 %.
 */
final class ManyCornered implements Scenes {

    private static final double RADIUS = 1;
    private static final double ANGLE = Math.toRadians(10);
    private static final double SPEED = 1;
    private static final double WAY = 5;

    /** The share by which the phase of the rolling edge may change the comparison of two ways. */
    private static final double LEEWAY = 1e-3;

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
        WatchedPool pool = trial.earth();
        BodyDefinition wheel =
                slope.place(Solid.of(shape, 0.8, 0), RADIUS)
                        .velocity(SPEED * Math.cos(ANGLE), -SPEED * Math.sin(ANGLE))
                        .spin(-SPEED / RADIUS);
        Descent descent = new Descent(pool, slope, wheel);
        double a = 2 * Trial.GRAVITY * Math.sin(ANGLE) / 3;
        pool.run((Math.sqrt(SPEED * SPEED + 2 * a * WAY) - SPEED) / a);
        return descent.way();
    }
}

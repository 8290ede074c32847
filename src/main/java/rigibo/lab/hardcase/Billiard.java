package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/**
 * A smooth disc in a room, e = 1, v = (200, 153). Truth: unfolded at the walls its way is straight,
 * so each coordinate is a triangle wave of time: x = w − |((x0 + vt) mod 2w) − w| over the free way
 * w.
 */
final class Billiard implements HardCase {

    private static final double WIDTH = 10;
    private static final double HEIGHT = 8;
    private static final double RADIUS = 0.25;
    private static final double VX = 200;
    private static final double VY = 153;
    private static final double START_X = 4;
    private static final double START_Y = 3;

    /** Of both pairs of walls. */
    static final double BOUNCES_PER_SECOND = VX / (WIDTH - 2 * RADIUS) + VY / (HEIGHT - 2 * RADIUS);

    @Override
    public String row() {
        return "41";
    }

    @Override
    public String title() {
        return "a disc in a room follows the unfolded line";
    }

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.pool(Surroundings.space());
        RigidBody disc = disc(pool);
        boolean isExact = trial.preset() == Preset.EXACT;
        double horizon = (isExact ? 1000 : 100) / BOUNCES_PER_SECOND;
        while (pool.time() < horizon) {
            pool.step();
            double off = off(disc, pool.time());
            trial.measure("place after 1000 / 100 bounces", off, "of L", 1e-6, 1e-3);
            trial.measure("speed changed", speedChange(disc), "of v", 1e-12, 1e-3);
        }
    }

    /** Builds the room and the disc in it. */
    static RigidBody disc(WatchedPool pool) {
        BodyDefinition wall =
                BodyDefinition.fixed(Polygon.box(12, 1)).material(Surroundings.matter(0, 1));
        pool.add(wall.at(WIDTH / 2, -0.5));
        pool.add(wall.at(WIDTH / 2, HEIGHT + 0.5));
        pool.add(wall.at(-0.5, HEIGHT / 2).angle(Math.PI / 2));
        pool.add(wall.at(WIDTH + 0.5, HEIGHT / 2).angle(Math.PI / 2));
        return pool.add(
                BodyDefinition.dynamic(new Circle(RADIUS))
                        .at(START_X, START_Y)
                        .velocity(VX, VY)
                        .material(Surroundings.matter(0, 1)));
    }

    /** How far the disc is from where it is in truth, as a share of the room's width. */
    static double off(RigidBody disc, double time) {
        double x = RADIUS + wave(START_X - RADIUS + VX * time, WIDTH - 2 * RADIUS);
        double y = RADIUS + wave(START_Y - RADIUS + VY * time, HEIGHT - 2 * RADIUS);
        return Math.hypot(disc.x() - x, disc.y() - y) / WIDTH;
    }

    static double speedChange(RigidBody disc) {
        double speed = Math.hypot(disc.velocityX(), disc.velocityY());
        return Math.abs(speed / Math.hypot(VX, VY) - 1);
    }

    /** The triangle wave that rises from 0 to the free way and falls again. */
    private static double wave(double unfolded, double free) {
        return free - Math.abs(unfolded % (2 * free) - free);
    }
}

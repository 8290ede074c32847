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
        BodyDefinition wall =
                BodyDefinition.fixed(Polygon.box(12, 1)).material(Surroundings.matter(0, 1));
        pool.add(wall.at(WIDTH / 2, -0.5));
        pool.add(wall.at(WIDTH / 2, HEIGHT + 0.5));
        pool.add(wall.at(-0.5, HEIGHT / 2).angle(Math.PI / 2));
        pool.add(wall.at(WIDTH + 0.5, HEIGHT / 2).angle(Math.PI / 2));
        double startX = 4;
        double startY = 3;
        RigidBody disc =
                pool.add(
                        BodyDefinition.dynamic(new Circle(RADIUS))
                                .at(startX, startY)
                                .velocity(VX, VY)
                                .material(Surroundings.matter(0, 1)));
        double perSecond = VX / (WIDTH - 2 * RADIUS) + VY / (HEIGHT - 2 * RADIUS);
        boolean isExact = trial.preset() == Preset.EXACT;
        double horizon = (isExact ? 1000 : 100) / perSecond;
        double speed = Math.hypot(VX, VY);
        while (pool.time() < horizon) {
            pool.step();
            double x = RADIUS + wave(startX - RADIUS + VX * pool.time(), WIDTH - 2 * RADIUS);
            double y = RADIUS + wave(startY - RADIUS + VY * pool.time(), HEIGHT - 2 * RADIUS);
            double off = Math.hypot(disc.x() - x, disc.y() - y) / WIDTH;
            trial.measure("place after 1000 / 100 bounces", off, "of L", 1e-6, 1e-3);
            double change = Math.hypot(disc.velocityX(), disc.velocityY()) / speed - 1;
            trial.measure("speed changed", Math.abs(change), "of v", 1e-12, 1e-3);
        }
    }

    /** The triangle wave that rises from 0 to the free way and falls again. */
    private static double wave(double unfolded, double free) {
        return free - Math.abs(unfolded % (2 * free) - free);
    }
}

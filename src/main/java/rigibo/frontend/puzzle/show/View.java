package rigibo.frontend.puzzle.show;

import rigibo.backend.geometry.Aabb;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.World;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Scenery;

/**
 * Fits the play between the bar at the top and the keys at the bottom. Levels leave a margin of
 * their world to these two, in which at most beams hang; anything else that opens below the bar
 * makes the picture smaller, and covers nothing.
 */
public final class View {

    /** Lower edge of the bar with title and clicks, px. */
    public static final double BAR_FOOT = 56;

    /** Upper edge of the keys, px. */
    public static final double KEYS_TOP = Scene.HEIGHT - 32;

    /** Margin that levels leave at their upper and lower edges, m. */
    private static final double SKY = 0.7;

    private static final double GROUND = 0.4;

    private final World world;
    private final Camera camera;

    /** Height above all that the level shows at its start, m. */
    private final double empty;

    public View(Level level) {
        world = level.world();
        empty = world.height() - highest(level);
        camera = new Camera(world.width() / 2, world.height() / 2, Camera.DEFAULT_SCALE);
        fitBelow(BAR_FOOT);
    }

    private static double highest(Level level) {
        Aabb bounds = new Aabb();
        double highest = 0;
        for (LevelBody body : level.bodies()) {
            double angle = body.angle();
            body.shape().bounds(body.x(), body.y(), Math.cos(angle), Math.sin(angle), bounds);
            highest = Math.max(highest, bounds.maxY);
        }
        return highest;
    }

    /** What is behind the level: where things fall as slowly as on the Moon, they are there. */
    public Scenery scenery() {
        return world.isOnTheMoon() ? Scenery.MOON : Scenery.WORKSHOP;
    }

    public Camera camera() {
        return camera;
    }

    /** Sets the height of the window at which the play begins, px. */
    public void fitBelow(double foot) {
        double sky = foot > BAR_FOOT ? Math.min(SKY, empty) : SKY;
        double room = KEYS_TOP - foot;
        double scale =
                Math.min(Scene.WIDTH / world.width(), room / (world.height() - sky - GROUND));
        double middle = (GROUND + world.height() - sky) / 2;
        double aside = (foot + room / 2 - Scene.HEIGHT / 2.0) / scale;
        camera.look(world.width() / 2, middle + aside, scale);
    }
}

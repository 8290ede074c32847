package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.World;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Scene;

/**
 * Fits the play between the bar at the top and the keys at the bottom. Levels leave a margin of
 * their world free for these two; anything else that opens below the bar makes the picture smaller.
 */
final class View {

    /** Lower edge of the bar with title and clicks, px. */
    static final double BAR_FOOT = 56;

    /** Upper edge of the keys, px. */
    static final double KEYS_TOP = Scene.HEIGHT - 32;

    /** Margin that levels leave free at their upper and lower edges, m. */
    private static final double SKY = 0.7;

    private static final double GROUND = 0.4;

    private final World world;
    private final Camera camera;

    View(World world) {
        this.world = world;
        camera = new Camera(world.width() / 2, world.height() / 2, Camera.DEFAULT_SCALE);
        fitBelow(BAR_FOOT);
    }

    Camera camera() {
        return camera;
    }

    /** Sets the height of the window at which the play begins, px. */
    void fitBelow(double foot) {
        double room = KEYS_TOP - foot;
        double scale =
                Math.min(Scene.WIDTH / world.width(), room / (world.height() - SKY - GROUND));
        double middle = (GROUND + world.height() - SKY) / 2;
        double aside = (foot + room / 2 - Scene.HEIGHT / 2.0) / scale;
        camera.look(world.width() / 2, middle + aside, scale);
    }
}

package rigibo.frontend.puzzle.show;

import rigibo.backend.geometry.Aabb;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.World;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Scenery;

/**
 * Fits the play between the bar at the top and the keys at the bottom. Levels leave a margin of
 * their world for these two, in which only beams hang. Where a ball begins in it, and where other
 * panels open below the bar, the picture gets smaller, so that they cover nothing. Two fingers
 * enlarge a part of it.
 */
public final class View {

    /** Lower edge of the bar with title and clicks, px. */
    public static final double BAR_FOOT = 56;

    /** Upper edge of the keys, px. */
    public static final double KEYS_TOP = Scene.HEIGHT - 32;

    /** Margin that levels leave at their upper and lower edges, m. */
    private static final double SKY = 0.7;

    private static final double GROUND = 0.4;

    /** Greatest enlargement of the picture, at which 20 cm are as wide as a finger on a phone. */
    private static final double MOST = 5;

    private final World world;
    private final Camera camera;

    /** Upper edge of the play, px. */
    private double foot = BAR_FOOT;

    /** Enlargement of the picture, and the point in its middle, world m. */
    private double enlarged = 1;

    private double middleX;
    private double middleY;

    /** Empty height above all balls of the level at its start, and above all parts of it, m. */
    private final double emptyOfBalls;

    private final double empty;

    public View(Level level) {
        world = level.world();
        double ball =
                level.balls().stream().mapToDouble(it -> it.y() + it.radius()).max().orElse(0);
        emptyOfBalls = world.height() - ball;
        empty = Math.min(emptyOfBalls, world.height() - highest(level));
        camera = new Camera(world.width() / 2, world.height() / 2, Camera.DEFAULT_SCALE);
        showAll();
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

    /** The scenery behind the level: a moonscape if gravity is about that of the Moon. */
    public Scenery scenery() {
        return world.isOnTheMoon() ? Scenery.MOON : Scenery.WORKSHOP;
    }

    public Camera camera() {
        return camera;
    }

    /** Sets the height of the window at which the play begins, px. */
    public void fitBelow(double playTop) {
        foot = playTop;
        look();
    }

    /** Shows the whole picture. */
    public void showAll() {
        enlarged = 1;
        look();
    }

    /** Whether only a part of the picture is visible. */
    public boolean isEnlarged() {
        return enlarged > 1;
    }

    /** Moves or enlarges the visible part by two fingers; it stays within the whole picture. */
    public void pinch(Pinch pinch) {
        double next = Math.max(1, Math.min(MOST, enlarged * pinch.factor()));
        camera.pinch(new Pinch(next / enlarged, pinch.x(), pinch.y(), pinch.dx(), pinch.dy()));
        enlarged = next;
        middleX = camera.worldX(Scene.WIDTH / 2.0);
        middleY = camera.worldY(foot + room() / 2);
        look();
    }

    /** Height of the play, px. */
    private double room() {
        return KEYS_TOP - foot;
    }

    private void look() {
        double sky = foot > BAR_FOOT ? Math.min(SKY, empty) : Math.min(SKY, emptyOfBalls);
        double height = world.height() - sky - GROUND;
        double whole = Math.min(Scene.WIDTH / world.width(), room() / height);
        double scale = whole * enlarged;
        middleX = within(middleX, world.width() / 2, Scene.WIDTH / whole);
        middleY = within(middleY, GROUND + height / 2, room() / whole);
        double aside = (foot + room() / 2 - Scene.HEIGHT / 2.0) / scale;
        camera.look(middleX, middleY + aside, scale);
    }

    /** The middle of the visible part of a length, m, kept within the whole picture. */
    private double within(double wanted, double middle, double length) {
        double reach = length / 2 * (1 - 1 / enlarged);
        return Math.max(middle - reach, Math.min(middle + reach, wanted));
    }
}

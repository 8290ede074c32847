package rigibo.frontend.puzzle.picture;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.frontend.puzzle.level.Ball;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Scenery;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.joint.JointPen;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/** A picture of a level at its start, as large as possible. */
public final class LevelPicture implements SceneEntry.Picture {

    /** Largest scale on a card, px per m; few and small bodies are not enlarged further. */
    private static final double ON_A_CARD = 22;

    /** Opacity of water. */
    private static final double WATER = 0.3;

    private final double mostScale;
    private final List<Part> parts = new ArrayList<>();
    private final List<LevelJoint> joints;
    private final Scenery scenery;

    /** Height of the water's surface, m; empty if there is no water. */
    private final OptionalDouble water;

    /** The ball at which the faces look. */
    private final Ball first;

    /** The rectangle that the parts fill, m. */
    private final Aabb whole = new Aabb();

    /** A picture for a card in a list. */
    public LevelPicture(Level level) {
        this(level, ON_A_CARD);
    }

    /**
     * A picture of any size.
     *
     * @param mostScale largest scale, px per m
     */
    public LevelPicture(Level level, double mostScale) {
        this.mostScale = mostScale;
        first = level.balls().get(0);
        joints = level.joints();
        scenery = level.world().isOnTheMoon() ? Scenery.MOON : Scenery.WORKSHOP;
        water = level.world().waterLevel();
        parts.addAll(Goal.of(level).parts());
        level.bodies().forEach(body -> parts.add(Part.of(body)));
        for (Ball ball : level.balls()) {
            parts.add(new Part(new Circle(ball.radius()), ball.x(), ball.y(), 0, Skin.BALL));
        }
        measure();
    }

    private void measure() {
        Aabb own = new Aabb();
        parts.get(0).bounds(whole);
        for (Part part : parts) {
            part.bounds(own);
            whole.minX = Math.min(whole.minX, own.minX);
            whole.minY = Math.min(whole.minY, own.minY);
            whole.maxX = Math.max(whole.maxX, own.maxX);
            whole.maxY = Math.max(whole.maxY, own.maxY);
        }
    }

    @Override
    public Scenery scenery() {
        return scenery;
    }

    @Override
    public void draw(Canvas canvas, double x, double y, double width, double height) {
        Camera camera = camera(x, y, width, height);
        canvas.camera(camera);
        canvas.gaze(first.x(), first.y());
        parts.forEach(part -> part.draw(canvas));
        water.ifPresent(surface -> drawWater(canvas, camera, surface));
        JointPen pen = new JointPen(canvas, camera);
        joints.forEach(joint -> JointSketch.draw(pen, joint));
    }

    /** Draws the water over the width and depth of the level's parts. */
    private void drawWater(Canvas canvas, Camera camera, double surface) {
        double left = camera.screenX(whole.minX);
        double top = camera.screenY(surface);
        double wide = camera.screenX(whole.maxX) - left;
        double deep = camera.screenY(whole.minY) - top;
        canvas.panel(left, top, wide, deep, 0, Color.ICE.alpha(WATER));
        canvas.line(left, top, left + wide, top, 2, Color.ICE.alpha(2 * WATER));
    }

    /** Places the middle of the level in the middle of a rectangle, px. */
    private Camera camera(double x, double y, double width, double height) {
        double fitting =
                Math.min(width / (whole.maxX - whole.minX), height / (whole.maxY - whole.minY));
        double scale = Math.min(mostScale, fitting);
        Camera plain = new Camera(0, 0, scale);
        return new Camera(
                (whole.minX + whole.maxX) / 2 - plain.worldX(x + width / 2),
                (whole.minY + whole.maxY) / 2 - plain.worldY(y + height / 2),
                scale);
    }
}

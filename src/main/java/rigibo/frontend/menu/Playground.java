package rigibo.frontend.menu;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/** The play area at the bottom of the menu: a few RigiBos that watch the pointer, and a ball. */
final class Playground {

    private static final double BOX = 0.7;

    private final Camera camera = Camera.ofPuzzle();
    private final Pool pool = new Pool();
    private final List<RigidBody> boxes = new ArrayList<>();
    private final RigidBody ball;
    private double watchedX = Scene.WIDTH / 2.0;
    private double watchedY = Scene.HEIGHT;

    Playground() {
        pool.add(BodyDefinition.fixed(Polygon.box(9, 1)).at(4.5, -0.02));
        for (int i = 0; i < 3; i++) {
            boxes.add(box(0.7 + 0.8 * i, 0.9, BOX));
        }
        boxes.add(box(1.1, 3, BOX));
        boxes.add(box(7.9, 2, 0.9));
        ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.35))
                                .at(4.6, 4)
                                .velocity(0.4, 0)
                                .material(new Material(1, 0.5, 0.75)));
    }

    private RigidBody box(double x, double y, double size) {
        return pool.add(
                BodyDefinition.dynamic(Polygon.box(size, size))
                        .at(x, y)
                        .material(new Material(1, 0.5, 0.3)));
    }

    void step() {
        pool.step(Scene.STEP);
    }

    /** Moves the pointer, px. */
    void pointerMoved(double x, double y) {
        watchedX = x;
        watchedY = y;
    }

    void draw(Canvas canvas) {
        camera.home();
        if (canvas.layout().isInHand()) {
            camera.pan(0, canvas.layout().bottom() - Scene.HEIGHT);
        }
        canvas.camera(camera);
        canvas.gaze(camera.worldX(watchedX), camera.worldY(watchedY));
        canvas.body(plank(canvas), 4.5, -0.02, 0, Skin.WOOD, Canvas.Mood.PLAIN);
        for (RigidBody box : boxes) {
            canvas.body(box.shape(), box.x(), box.y(), box.angle(), Skin.RIGIBO, Canvas.Mood.PLAIN);
        }
        canvas.body(ball.shape(), ball.x(), ball.y(), ball.angle(), Skin.BALL, Canvas.Mood.PLAIN);
    }

    /** The floor from one edge of the window to the other, its ends out of sight. */
    private static Polygon plank(Canvas canvas) {
        return Polygon.box(canvas.layout().width() / Camera.DEFAULT_SCALE + 0.4, 1);
    }
}

package rigibo.frontend.demo;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Logarithm;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Words;

import java.util.function.DoubleSupplier;

/**
 * A ball that bounces by itself beside the scene. After n bounces it must rise to e²ⁿh; the
 * difference is the error of the present accuracy.
 */
final class ReferenceBall {

    /** The formula of the height after n bounces; e is the elasticity. */
    static final String FORMULA = "h·e^(2n)";

    private static final double G = 9.81;
    private static final double RADIUS = 0.4;
    private static final double HEIGHT = 8;

    /** Rise below which the ball is dropped anew, m, since it cannot be seen. */
    private static final double LEAST_RISE = 0.02;

    private final double x;
    private final DoubleSupplier elasticity;
    private RigidBody ball;
    private double dropped;
    private int bounces;
    private boolean wasFalling;
    private double risen;

    /** Makes a ball above a floor at y = 0, at a given x in m; every drop states its elasticity. */
    ReferenceBall(double x, DoubleSupplier elasticity) {
        this.x = x;
        this.elasticity = elasticity;
    }

    /** Drops the ball anew. */
    void drop(Workbench bench) {
        if (ball != null) {
            bench.remove(ball);
        }
        dropped = elasticity.getAsDouble();
        bounces = 0;
        wasFalling = true;
        risen = HEIGHT;
        ball =
                bench.add(
                        BodyDefinition.dynamic(new Circle(RADIUS))
                                .at(x, HEIGHT + RADIUS)
                                .material(new Material(1, 0, dropped)),
                        Skin.BALL);
    }

    /** Counts bounces, and predicts the height of the rise from the speed on the way up. */
    void afterStep(Workbench bench) {
        boolean isFalling = ball.velocityY() <= 0;
        if (wasFalling && !isFalling) {
            bounces++;
            double v = ball.velocityY();
            risen = ball.y() - RADIUS + v * v / (2 * G);
        }
        wasFalling = isFalling;
        boolean isOver = isFalling && predicted() < LEAST_RISE;
        if (isOver || dropped != elasticity.getAsDouble()) {
            drop(bench);
        }
    }

    private double predicted() {
        return Logarithm.pow(dropped, 2 * bounces) * HEIGHT;
    }

    /** Height of the present rise by the formula. */
    String predictedIn(Words words) {
        return words.number("%.4f m", predicted());
    }

    /** Height of the present rise in the pool. */
    String seenIn(Words words) {
        return words.number("%.4f m", risen);
    }

    /** A mark at the height that the middle of the ball must reach. */
    void draw(Camera camera, Canvas canvas) {
        double y = camera.screenY(predicted() + RADIUS);
        double middle = camera.screenX(x);
        canvas.line(middle - 36, y, middle + 36, y, 2, Color.BRASS);
    }
}

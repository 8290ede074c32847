package rigibo.frontend.puzzle.show;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** The glow around fire doors, and the drops that run down them while they melt. */
final class Embers {

    private static final Color HOT = Color.of(0xFFC766);

    /** Distance between two lights along the door, and width of a light, m. */
    private static final double SPACING = 0.35;

    private static final double WIDTH = 1.1;

    /** Strength of a light before the door melts and at the end. */
    private static final double DIM = 0.16;

    private static final double BRIGHT = 0.75;

    /** Period of the pulsing light, steps. */
    private static final double BREATH = 110;

    /** Distance between two drops, m, and the radius of one, px. */
    private static final double PITCH = 0.16;

    private static final double DROP = 4;

    /** Distance that drops run below the door until it is gone, m. */
    private static final double RUN = 0.5;

    private Embers() {}

    static void draw(Canvas canvas, Camera camera, Piece piece, Pose pose, int steps) {
        if (piece.substance() != Substance.EMBER) {
            return;
        }
        double melted = piece.melt().map(melt -> melt.share(steps)).orElse(0.0);
        Shape shape = piece.body().shape();
        double breath = 1 + 0.25 * Math.sin(2 * Math.PI * steps / BREATH);
        Color color = Color.EMBER.alpha(DIM * breath + (BRIGHT - DIM) * melted);
        Aabb own = new Aabb();
        shape.bounds(0, 0, 1, 0, own);
        double wide = own.maxX - own.minX;
        double high = own.maxY - own.minY;
        int lights = (int) Math.ceil(Math.max(wide, high) / SPACING);
        for (int i = 0; i < lights; i++) {
            double along = (i + 0.5) / lights;
            boolean isLevel = wide > high;
            double x = own.minX + (isLevel ? along : 0.5) * wide;
            double y = own.minY + (isLevel ? 0.5 : along) * high;
            Pose at = pose.at(x, y);
            canvas.glow(at.x(), at.y(), WIDTH, color);
            canvas.glow(at.x(), at.y(), WIDTH / 2, HOT.alpha(melted));
        }
        if (melted > 0) {
            drawDrops(canvas, camera, shape, pose, melted);
        }
    }

    private static void drawDrops(
            Canvas canvas, Camera camera, Shape shape, Pose pose, double melted) {
        Aabb bounds = new Aabb();
        shape.bounds(pose.x(), pose.y(), Math.cos(pose.angle()), Math.sin(pose.angle()), bounds);
        int drops = (int) Math.max(1, (bounds.maxX - bounds.minX) / PITCH);
        double high = bounds.maxY - bounds.minY;
        for (int i = 0; i < drops; i++) {
            double x = bounds.minX + (i + 0.5) * (bounds.maxX - bounds.minX) / drops;
            // Each light has a phase of its own, so that they do not pulse together.
            double begun = 0.5 + 0.5 * Math.sin(2.4 * i + 1);
            double y = bounds.maxY - begun * high - melted * melted * (RUN + (1 - begun) * high);
            double radius = DROP * (0.6 + 0.4 * melted);
            canvas.disc(camera.screenX(x), camera.screenY(y), radius, HOT);
        }
    }
}

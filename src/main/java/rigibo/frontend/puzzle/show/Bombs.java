package rigibo.frontend.puzzle.show;

import rigibo.frontend.puzzle.level.Verb;
import rigibo.frontend.puzzle.rules.Fuse;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.session.Pose;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.Optional;

/** Draws the fuses of bombs, which burn down towards the bomb, and the time that is left. */
final class Bombs {

    private static final Color CORD = Color.of(0xD9C8A2);
    private static final Color CORD_EDGE = Color.of(0x23190F);
    static final Color FLAME = Color.of(0xFFB347);

    /** Number of points of a fuse, its length as a share of the bomb's radius, and its width, m. */
    private static final int POINTS = 9;

    private static final double LENGTH = 0.9;
    private static final double WIDTH = 0.045;

    /** Width of the light about the spark, m. */
    private static final double GLOW = 0.75;

    /** Distance of the ring of time from the bomb, px. */
    private static final double RING_GAP = 7;

    private Bombs() {}

    static void draw(Canvas canvas, Camera camera, Piece piece, Pose pose, int steps) {
        if (!piece.is(Verb.LIGHT)) {
            return;
        }
        double burnt = piece.fuse().map(fuse -> fuse.burnt(steps)).orElse(0.0);
        double radius = piece.body().shape().boundingRadius();
        double[] xy = new double[2 * POINTS];
        Pose end = pose;
        for (int i = 0; i < POINTS; i++) {
            double share = (1 - burnt) * i / (POINTS - 1.0);
            // A quarter of a wave, out of the bomb's upper side.
            double aside = 0.35 * radius * Math.sin(0.5 * Math.PI * share);
            end = pose.at(aside, 0.75 * radius + LENGTH * radius * share);
            xy[2 * i] = camera.screenX(end.x());
            xy[2 * i + 1] = camera.screenY(end.y());
        }
        double width = WIDTH * camera.scale();
        canvas.curve(xy, POINTS, width + 2, CORD_EDGE);
        canvas.curve(xy, POINTS, width, CORD);
        Optional<Fuse> fuse = piece.fuse();
        if (fuse.isPresent()) {
            double flicker = 0.8 + 0.2 * Math.sin(1.7 * steps);
            canvas.glow(end.x(), end.y(), GLOW * flicker, FLAME.alpha(0.7));
            spark(canvas, camera.screenX(end.x()), camera.screenY(end.y()), steps);
            double ring = radius * camera.scale() + RING_GAP;
            canvas.ring(
                    camera.screenX(pose.x()), camera.screenY(pose.y()), ring, 3, 1 - burnt, FLAME);
        }
    }

    private static void spark(Canvas canvas, double x, double y, int steps) {
        for (int ray = 0; ray < 5; ray++) {
            double angle = 2 * Math.PI * ray / 5 + 0.9 * steps;
            double reach = 6 + 3 * Math.sin(2.3 * steps + ray);
            canvas.line(x, y, x + reach * Math.cos(angle), y + reach * Math.sin(angle), 1.8, FLAME);
        }
        canvas.disc(x, y, 3, Color.TEXT);
    }
}

package rigibo.frontend.puzzle.show;

import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;

import java.util.Optional;

/** The pointer of a shown solution or replay: it moves to each target in time for its click. */
final class ShownPointer {

    /** Time that the pointer takes to reach a target. */
    private static final int WAY = Steps.of(0.7);

    /** Time for which a click is visible. */
    private static final int RIPPLE = Steps.of(0.4);

    /** Height of the arrow, whose tip is the point of the click, px. */
    private static final double ARROW = 32;

    /** The second row that keys take with large letters, px: the arrow begins above it. */
    private static final double SECOND_ROW = 32;

    private final Camera camera;
    private double fromX = Scene.WIDTH / 2.0;
    private double fromY = View.KEYS_TOP - SECOND_ROW - ARROW;
    private int rippleTurns;

    ShownPointer(Camera camera) {
        this.camera = camera;
    }

    /** Called when a click was made at a point of the world, m. */
    void clicked(double worldX, double worldY) {
        fromX = camera.screenX(worldX);
        fromY = camera.screenY(worldY);
        rippleTurns = RIPPLE;
    }

    /** After each frame. */
    void turn() {
        rippleTurns = Math.max(0, rippleTurns - 1);
    }

    void draw(Canvas canvas, Playback playback) {
        Optional<Target> next = playback.upcoming().flatMap(to -> target(playback, to));
        int left = playback.upcoming().map(to -> to.step() - playback.game().steps()).orElse(WAY);
        double share = Math.max(0, Math.min(1, 1 - left / (double) WAY));
        double x = next.map(at -> between(fromX, camera.screenX(at.x()), share)).orElse(fromX);
        double y = next.map(at -> between(fromY, camera.screenY(at.y()), share)).orElse(fromY);
        if (rippleTurns > 0) {
            double radius = 10 + 20 * (1 - rippleTurns / (double) RIPPLE);
            canvas.ring(fromX, fromY, radius, 3, 1, Color.BRASS);
        }
        drawArrow(canvas, x, y);
    }

    private static Optional<Target> target(Playback playback, Act act) {
        return playback.game().target(act.target()).filter(Target::isClickable);
    }

    private static double between(double from, double to, double share) {
        return from + (to - from) * share;
    }

    /** Draws a bright arrow with a dark edge. */
    private static void drawArrow(Canvas canvas, double x, double y) {
        drawArrow(canvas, x, y, 8, Color.DUSK_TOP);
        drawArrow(canvas, x, y, 4, Color.BRASS);
    }

    private static void drawArrow(Canvas canvas, double x, double y, double width, Color color) {
        canvas.line(x, y, x, y + 22, width, color);
        canvas.line(x, y, x + 16, y + 16, width, color);
        canvas.line(x, y + 22, x + 16, y + 16, width, color);
        canvas.line(x + 6, y + 17, x + 11, y + 28, width, color);
    }
}

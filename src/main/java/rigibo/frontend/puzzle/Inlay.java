package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Platform;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** Diamonds of brass in the platform, which distinguish it from other wood. */
final class Inlay {

    /** Distance between two diamonds, m. */
    private static final double APART = 0.45;

    /** Size of a diamond, as a share of the platform's height, and a factor for its edge. */
    private static final double SIZE = 0.36;

    private static final double WITH_EDGE = 1.35;
    private static final Color EDGE = Color.of(0x5C3A1E);

    private Inlay() {}

    /**
     * Draws as many diamonds as fit about the platform's middle; once the game is lost they do not
     * shine.
     */
    static void draw(Canvas canvas, PuzzleGame game) {
        Platform platform = game.level().platform();
        int count = Math.max(1, (int) Math.round(platform.width() / APART) - 1);
        double size = SIZE * platform.height();
        double angle = platform.angle() + Math.PI / 4;
        Color brass = game.outcome() == Outcome.LOST ? Color.EDGE : Color.BRASS;
        for (int i = 0; i < count; i++) {
            double along = (i - (count - 1) / 2.0) * APART;
            double x = platform.x() + along * Math.cos(platform.angle());
            double y = platform.y() + along * Math.sin(platform.angle());
            canvas.particle(x, y, WITH_EDGE * size, angle, EDGE);
            canvas.particle(x, y, size, angle, brass);
        }
    }
}

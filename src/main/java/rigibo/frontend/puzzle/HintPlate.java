package rigibo.frontend.puzzle;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;

import java.util.List;

/** The level's hint, between the bar and the play, with a button that shows the solution. */
final class HintPlate {

    private static final double EDGE = 8;
    private static final double TOP = View.BAR_FOOT + 6;
    private static final double HEIGHT = 56;

    /** Upper edge of the play while the plate is shown, px. */
    static final double FOOT = TOP + HEIGHT + 6;

    private static final double TEXT_LEFT = EDGE + 52;
    private static final double BUTTON_WIDTH = 190;
    private static final double BUTTON_LEFT = Scene.WIDTH - EDGE - 10 - BUTTON_WIDTH;
    private static final double SIZE = 17;
    private static final double LINE = 22;

    private final String hint;
    private final ButtonRow buttons =
            new ButtonRow(
                    BUTTON_LEFT,
                    TOP + (HEIGHT - ButtonRow.HEIGHT) / 2,
                    BUTTON_WIDTH,
                    List.of(Command.SOLUTION));
    private final boolean hasSolution;

    HintPlate(String hint, boolean hasSolution) {
        this.hint = hint;
        this.hasSolution = hasSolution;
    }

    void draw(Canvas canvas, Words words) {
        canvas.panel(EDGE, TOP, Scene.WIDTH - 2 * EDGE, HEIGHT, 14, Color.PANEL);
        drawBulb(canvas, EDGE + 28, TOP + HEIGHT / 2);
        double right = hasSolution ? BUTTON_LEFT : Scene.WIDTH - EDGE;
        List<String> lines =
                Lines.of(canvas, hint, SIZE, Canvas.Font.WORDS, right - 10 - TEXT_LEFT);
        double y = TOP + HEIGHT / 2 - (lines.size() - 1) * LINE / 2;
        for (String line : lines) {
            canvas.text(line, TEXT_LEFT, y, SIZE, Canvas.Font.WORDS, Canvas.Align.LEFT, Color.TEXT);
            y += LINE;
        }
        if (hasSolution) {
            buttons.draw(canvas, words);
        }
    }

    private static void drawBulb(Canvas canvas, double x, double y) {
        canvas.disc(x, y - 5, 11, Color.BRASS);
        canvas.panel(x - 5, y + 4, 10, 6, 2, Color.BRASS);
        canvas.panel(x - 4, y + 12, 8, 3, 1, Color.BRASS);
    }

    /** Whether a point lies on the button for the solution. */
    boolean isOnSolution(double x, double y) {
        return hasSolution && buttons.point(x, y).isPresent();
    }
}

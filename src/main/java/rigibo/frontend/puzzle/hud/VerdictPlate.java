package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.replay.Verdict;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Sign;

import java.util.List;

/** Says whether a replay ran as recorded. */
final class VerdictPlate {

    private static final double EDGE = 8;
    private static final double SIZE = 17;
    private static final double LINE = 22;

    /** Width of the sign on the left, and of the free space on the right, px. */
    private static final double ICON = 46;

    private static final double GAP = 14;

    private VerdictPlate() {}

    /**
     * Draws it at the upper end of the play, or beside it if the window has room.
     *
     * @param foot upper edge of the play, px
     */
    static void draw(Canvas canvas, Words words, Verdict verdict, double foot) {
        Layout layout = canvas.layout();
        boolean isBeside = layout.columns() == 2 && !layout.isInHand();
        double left = isBeside ? layout.leftColumn() : EDGE;
        double width = isBeside ? layout.columnWidth() : Scene.WIDTH - 2 * EDGE;
        double top = isBeside ? EDGE : foot + 6;
        String said = verdict.in(words);
        List<String> lines = Lines.of(canvas, said, SIZE, Canvas.Font.WORDS, width - ICON - GAP);
        double line = layout.lettered(LINE);
        double height = lines.size() * line + 16;
        Color color = verdict.isSame() ? Color.GOOD : Color.BAD;
        canvas.panel(left, top, width, height, 14, Color.PANEL);
        canvas.frame(left, top, width, height, 14, color);
        drawIcon(canvas, left + 26, top + height / 2, verdict.isSame(), color);
        double y = top + 8 + line / 2;
        for (String part : lines) {
            Print.left(canvas, part, left + ICON, y, SIZE, Color.TEXT);
            y += line;
        }
    }

    private static void drawIcon(Canvas canvas, double x, double y, boolean isGood, Color color) {
        canvas.ring(x, y, 11, 3, 1, color);
        if (isGood) {
            Sign.tick(canvas, x, y, 5, 3, color);
        } else {
            Sign.cross(canvas, x, y, 4, 3, color);
        }
    }
}

package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.List;

/**
 * The level's hint, between the bar and the play or beside it, with a button that shows the
 * solution.
 */
final class HintPlate {

    private static final double EDGE = 8;
    private static final double TOP = View.BAR_FOOT + 6;
    private static final double HEIGHT = 56;

    /** Upper edge of the play while the plate is shown, px. */
    static final double FOOT = TOP + HEIGHT + 6;

    /** Room for the bulb before the text, px. */
    private static final double INDENT = 52;

    private static final double BUTTON_WIDTH = 190;
    private static final double BUTTON_LEFT = Scene.WIDTH - EDGE - 10 - BUTTON_WIDTH;
    private static final double BUTTON_TOP = TOP + (HEIGHT - ButtonRow.HEIGHT) / 2;
    private static final double SIZE = 17;
    private static final double LINE = 22;

    private final String hint;
    private final boolean hasSolution;
    private Plate place = Plate.NONE;

    /** Position of the button that shows the solution. */
    private Plate button = Plate.NONE;

    private ButtonRow buttons;

    HintPlate(String hint, boolean hasSolution) {
        this.hint = hint;
        this.hasSolution = hasSolution;
        put(new Plate(BUTTON_LEFT, BUTTON_TOP, BUTTON_WIDTH, ButtonRow.HEIGHT));
    }

    private void put(Plate there) {
        if (!there.equals(button)) {
            button = there;
            List<Command> commands = List.of(Command.SOLUTION);
            buttons = new ButtonRow(Grid.of(button, commands.size(), 0), commands);
        }
    }

    /** Draws it above the play. */
    void draw(Canvas canvas, Words words) {
        put(new Plate(BUTTON_LEFT, BUTTON_TOP, BUTTON_WIDTH, ButtonRow.HEIGHT));
        double right = hasSolution ? BUTTON_LEFT : Scene.WIDTH - EDGE;
        List<String> lines = lines(canvas, right - EDGE - INDENT - 10);
        place = new Plate(EDGE, TOP, Scene.WIDTH - 2 * EDGE, HEIGHT);
        double first = TOP + HEIGHT / 2 - (lines.size() - 1) * LINE / 2;
        draw(canvas, words, TOP + HEIGHT / 2, lines, first);
    }

    /** Draws it beside the play, in the right column, with the button below the hint. */
    void drawBeside(Canvas canvas, Words words) {
        double x = canvas.layout().rightColumn();
        double width = canvas.layout().columnWidth();
        List<String> lines = lines(canvas, width - INDENT - 10);
        double below = EDGE + 10 + lines.size() * LINE + 8;
        put(new Plate(x + 10, below, width - 20, ButtonRow.HEIGHT));
        double height = (hasSolution ? below + ButtonRow.HEIGHT + 10 : below) - EDGE;
        place = new Plate(x, EDGE, width, height);
        double first = EDGE + 10 + LINE / 2;
        draw(canvas, words, first + 6, lines, first);
    }

    /**
     * Draws it in a handheld window, with the button below the hint: its place has a width and no
     * height.
     */
    void drawInHand(Canvas canvas, Words words, Plate there) {
        double line = canvas.layout().lettered(LINE);
        double button = canvas.layout().clickable(ButtonRow.HEIGHT);
        List<String> lines = lines(canvas, there.width() - INDENT - 10);
        double below = there.y() + 10 + lines.size() * line + 8;
        put(new Plate(there.x() + 10, below, there.width() - 20, button));
        double bottom = hasSolution ? below + button + 10 : below;
        place = new Plate(there.x(), there.y(), there.width(), bottom - there.y());
        double first = there.y() + 10 + line / 2;
        draw(canvas, words, first + 6, lines, first);
    }

    /** Upper edge of the play below the plate as drawn last, or below its bar, px. */
    double foot(double bar) {
        return Math.max(bar, place.bottom());
    }

    private List<String> lines(Canvas canvas, double width) {
        return Lines.of(canvas, hint, SIZE, Canvas.Font.WORDS, width);
    }

    private void draw(
            Canvas canvas, Words words, double bulb, List<String> lines, double firstLine) {
        canvas.panel(place.x(), place.y(), place.width(), place.height(), 14, Color.PANEL);
        drawBulb(canvas, place.x() + 28, bulb);
        for (int i = 0; i < lines.size(); i++) {
            double y = firstLine + i * canvas.layout().lettered(LINE);
            Print.left(canvas, lines.get(i), place.x() + INDENT, y, SIZE, Color.TEXT);
        }
        if (hasSolution) {
            buttons.draw(canvas, words);
        }
    }

    /** Describes the hint and its button to a screen reader. */
    void describe(Narrator narrator, Words words) {
        narrator.says(hint);
        if (hasSolution) {
            buttons.describe(narrator, words);
        }
    }

    /** Whether a point lies on the plate as drawn last. */
    boolean contains(double x, double y) {
        return place.contains(x, y);
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

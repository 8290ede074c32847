package rigibo.frontend.editor.pane;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;

import java.util.List;

/**
 * Draws parts of panes: plates, texts shortened to their room, buttons.
 *
 * @param canvas to draw on
 * @param spots that can be pressed
 * @param words in the player's language
 * @param pointerX px
 * @param pointerY px
 */
public record Pane(Canvas canvas, Spots spots, Words words, double pointerX, double pointerY) {

    /** Height of a line of text, px. */
    public static final double LINE = 22;

    static final double TEXT = 16;
    static final double CORNER = 7;
    private static final double PADDING = 8;

    /** What lines of a text are narrower than their area, px. */
    private static final double ROUND = 10;

    /** Margin that buttons side by side give up where room is scarce, px. */
    static final double TIGHTENED = 11;

    /** Opaque: the world goes on below. */
    private static final Color PLATE = Color.PANEL.alpha(1);

    /** A plate that keeps presses from reaching what lies below it. */
    public void plate(Area area) {
        canvas.panel(area.x(), area.y(), area.width(), area.height(), 12, PLATE);
        spots.add(area, "", "", () -> {});
    }

    boolean isHot(Area area) {
        return area.contains(pointerX, pointerY);
    }

    /** Height of something to press, px: in a handheld window, at least that of a finger. */
    double pressable(double usual) {
        return canvas.layout().clickable(usual);
    }

    /** A button with its name on it. */
    public void button(Area area, String name, Color plate, String told, Runnable action) {
        button(area, name, name, plate, told, action);
    }

    /** A button with a sign on it, which says more to the eye than to the ear. */
    public void button(
            Area area, String sign, String name, Color plate, String told, Runnable action) {
        Color lit = isHot(area) ? Color.EDGE : plate;
        canvas.panel(area.x(), area.y(), area.width(), area.height(), CORNER, lit);
        Color ink = lit.equals(Color.BRASS) ? Color.DUSK_TOP : Color.TEXT;
        String fitting = fitted(sign, area.width(), Canvas.Font.WORDS);
        canvas.text(
                fitting,
                area.middleX(),
                area.middleY(),
                TEXT,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                ink);
        spots.add(area, name, told, action);
    }

    /** Width of an area that words fit on, px. */
    double width(String name) {
        return canvas.textWidth(name, TEXT, Canvas.Font.WORDS) + 2 * PADDING;
    }

    /** Width of one of several buttons side by side; less where text is enlarged, px. */
    double tightWidth(String name) {
        return width(name) - (canvas.layout().type() > 1 ? TIGHTENED : 0);
    }

    /** Words within an area, shortened at their end where they are too long. */
    public void text(Area area, String line, Canvas.Align align, Color color) {
        double x =
                switch (align) {
                    case LEFT -> area.x() + PADDING / 2;
                    case CENTRE -> area.middleX();
                    case RIGHT -> area.right() - PADDING / 2;
                };
        String fitting = fitted(line, area.width() - PADDING, Canvas.Font.WORDS);
        canvas.text(fitting, x, area.middleY(), TEXT, Canvas.Font.WORDS, align, color);
    }

    /**
     * Words from the top of an area, broken into as many lines as it has room for, and shortened at
     * their end where they are too long; returns where the next line would be, px.
     */
    public double lines(Area area, String told, Color color) {
        List<String> lines = Lines.of(canvas, told, TEXT, Canvas.Font.WORDS, area.width() - ROUND);
        int fitting = Math.min(lines.size(), Math.max(1, (int) (area.height() / LINE)));
        for (int i = 0; i < fitting; i++) {
            int end = i == fitting - 1 ? lines.size() : i + 1;
            Area row = new Area(area.x(), area.y() + i * LINE, area.width(), LINE);
            text(row, String.join(" ", lines.subList(i, end)), Canvas.Align.LEFT, color);
        }
        return area.y() + fitting * LINE;
    }

    /**
     * A value in a box of its own. Where it is too long, its end is shown while one types there.
     */
    public void value(Area area, String held, Canvas.Font font, boolean isTyped) {
        canvas.panel(area.x(), area.y(), area.width(), area.height(), 5, Color.DUSK_TOP);
        if (isTyped) {
            canvas.frame(area.x(), area.y(), area.width(), area.height(), 5, Color.BRASS);
        }
        double room = area.width() - PADDING;
        String shown = isTyped ? ending(held, room, font) : fitted(held, room, font);
        canvas.text(
                shown, area.middleX(), area.middleY(), TEXT, font, Canvas.Align.CENTRE, Color.TEXT);
    }

    private String fitted(String line, double room, Canvas.Font font) {
        String shown = line;
        while (canvas.textWidth(shown, TEXT, font) > room && shown.length() > 1) {
            shown = shown.substring(0, shown.length() - (shown.endsWith("…") ? 2 : 1)) + "…";
        }
        return shown;
    }

    private String ending(String line, double room, Canvas.Font font) {
        String shown = line;
        while (canvas.textWidth(shown, TEXT, font) > room && shown.length() > 1) {
            shown = shown.substring(1);
        }
        return shown;
    }
}

package rigibo.frontend.editor.pane;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.widget.Lines;

import java.util.List;

/** Buttons in a row, each as wide as its name; those that do not fit begin another row below. */
public final class Bar {

    private static final double GAP = 5;

    private final Pane pane;

    /** The present row. */
    private Area row;

    private double x;

    /**
     * A button of a bar.
     *
     * @param key of its name, after "editor."
     * @param isBright whether there is something to do
     * @param action what a press does
     */
    public record Button(String key, boolean isBright, Runnable action) {}

    /** A bar whose buttons begin at the left of its first row. */
    public Bar(Pane pane, Area first) {
        this.pane = pane;
        row = first;
        x = first.x();
    }

    /** Height of all rows of some buttons, px. */
    public static double height(Pane pane, Area first, List<Button> buttons) {
        Bar bar = new Bar(pane, first);
        buttons.forEach(button -> bar.place(button.key));
        return bar.row.bottom() - first.y();
    }

    /** Words before the buttons, which begin a row of their own where one line is too short. */
    public void words(String sentence, Color ink) {
        double room = row.width() - pane.width("");
        List<String> lines = Lines.of(pane.canvas(), sentence, Pane.TEXT, Canvas.Font.WORDS, room);
        for (String line : lines) {
            pane.text(place(pane.width(line)), line, Canvas.Align.LEFT, ink);
            if (lines.size() > 1) {
                next();
            }
        }
    }

    /** The next button; dimmed where there is nothing to do. */
    public void button(String key, boolean isBright, Runnable action) {
        Color plate = isBright ? Color.PANEL_LIT : Color.DUSK_TOP;
        String told = pane.words().of("editor." + key + ".told");
        pane.button(place(key), name(key), plate, told, action);
    }

    /** The next button. */
    public void button(Button button) {
        button(button.key, button.isBright, button.action);
    }

    private String name(String key) {
        return pane.words().of("editor." + key);
    }

    private Area place(String key) {
        return place(pane.tightWidth(name(key)));
    }

    private Area place(double width) {
        if (x > row.x() && x + width > row.right()) {
            next();
        }
        Area place = new Area(x, row.y(), width, row.height());
        x += width + GAP;
        return place;
    }

    private void next() {
        row = row.below(GAP, row.height());
        x = row.x();
    }

    /** The area that is left at the right of the buttons. */
    public Area rest() {
        return new Area(x, row.y(), row.right() - x, row.height());
    }

    /** The row below all buttons, px high. */
    public Area below(double height) {
        return row.below(0, height);
    }
}

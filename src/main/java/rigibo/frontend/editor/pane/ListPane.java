package rigibo.frontend.editor.pane;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.List;

/** A list to choose from, above everything else, one page at a time. */
public final class ListPane {

    /** From one row to the next, and the gap in between, px. */
    private static final double ROW = 34;

    private static final double GAP = 5;
    private static final double FOOT = 40;
    private static final double BUTTON = 30;

    /**
     * A line of the list.
     *
     * @param words what can be chosen
     * @param action what choosing it does
     */
    public record Choice(String words, Runnable action) {}

    private final String heading;
    private final List<Choice> choices;
    private final Runnable close;
    private int first;

    /** A list that is closed by its last button. */
    public ListPane(String heading, List<Choice> choices, Runnable close) {
        this.heading = heading;
        this.choices = List.copyOf(choices);
        this.close = close;
    }

    /** Draws the page that is looked at. */
    public void draw(Pane pane, Area area) {
        pane.plate(area);
        Area inner = area.inset(14);
        double row = pane.pressable(ROW - GAP) + GAP;
        double button = pane.pressable(BUTTON);
        int page = (int) ((inner.height() - row - button - (FOOT - BUTTON)) / row);
        pane.text(row(inner, 0, row), heading, Canvas.Align.LEFT, Color.BRASS);
        for (int i = 0; i < page && first + i < choices.size(); i++) {
            Choice choice = choices.get(first + i);
            pane.button(
                    row(inner, i + 1, row), choice.words(), Color.PANEL_LIT, "", choice.action());
        }
        double foot = inner.bottom() - button;
        foot(pane, new Area(inner.x(), foot, inner.width(), button), page);
    }

    private static Area row(Area inner, int i, double row) {
        return new Area(inner.x(), inner.y() + i * row, inner.width(), row - GAP);
    }

    private void foot(Pane pane, Area area, int page) {
        double third = area.width() / 3;
        if (choices.size() > page) {
            Area next = new Area(area.x(), area.y(), third - 5, area.height());
            int after = first + page < choices.size() ? first + page : 0;
            String words = pane.words().of("editor.page");
            pane.button(next, words, Color.PANEL_LIT, "", () -> first = after);
        }
        Area shut = new Area(area.x() + 2 * third, area.y(), third, area.height());
        pane.button(shut, pane.words().of("editor.close"), Color.PANEL_LIT, "", close);
    }
}

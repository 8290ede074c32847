package rigibo.frontend.editor.pane;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.widget.Spread;

import java.util.List;
import java.util.function.IntConsumer;

/** Rows of fields, from the top of an area downwards. */
final class Column {

    static final double ROW = 26;

    private static final double GAP = 2;
    private static final double SIGN = 22;
    private static final double VALUE = 66;

    /** What plus and minus leave to the value between them where text is enlarged, px. */
    private static final double SPARED = 5;

    private final Pane pane;
    private final Area area;
    private double y;

    Column(Pane pane, Area area) {
        this.pane = pane;
        this.area = area;
        y = area.y();
    }

    private Area row() {
        Area row = new Area(area.x(), y, area.width(), ROW - GAP);
        y += ROW;
        return row;
    }

    /** Names side by side, one of which is open. */
    void tabs(List<String> names, int open, IntConsumer turn) {
        Area row = row();
        double[] ends = Spread.ends(pane.canvas(), names, Pane.TEXT, row.width() + GAP);
        for (int i = 0; i < names.size(); i++) {
            int at = i;
            double left = i == 0 ? 0 : ends[i - 1];
            double width = ends[i] - left - GAP;
            Area tab = new Area(row.x() + left, row.y(), width, row.height());
            Color plate = i == open ? Color.BRASS : Color.PANEL_LIT;
            pane.button(tab, names.get(i), plate, "", () -> turn.accept(at));
        }
    }

    void heading(String words) {
        pane.text(row(), words, Canvas.Align.LEFT, Color.BRASS);
    }

    void note(String words) {
        pane.text(row(), words, Canvas.Align.LEFT, Color.TEXT_DIM);
    }

    /** A value between a minus and a plus; a press on it begins to type. */
    void stepper(String words, Shown shown, Runnable type, IntConsumer nudge) {
        Area row = row();
        double sign = pane.canvas().layout().type() > 1 ? SIGN - SPARED : SIGN;
        double left = row.right() - VALUE - 2 * SIGN;
        Area label = new Area(row.x(), row.y(), left - row.x(), row.height());
        pane.text(label, words, Canvas.Align.LEFT, Color.TEXT_DIM);
        pane.button(
                new Area(left, row.y(), sign, row.height()),
                "–",
                Color.PANEL_LIT,
                words,
                () -> nudge.accept(-1));
        double room = row.right() - left - 2 * sign;
        Area value = new Area(left + sign, row.y(), room, row.height());
        pane.value(value, shown.text(), shown.font(), shown.isTyped());
        pane.spots().add(value, words, type);
        pane.button(
                new Area(row.right() - sign, row.y(), sign, row.height()),
                "+",
                Color.PANEL_LIT,
                words,
                () -> nudge.accept(1));
    }

    /** A value over a whole row, between a minus and a plus. */
    void wide(String words, IntConsumer nudge) {
        Area row = row();
        Area value = new Area(row.x() + SIGN, row.y(), row.width() - 2 * SIGN, row.height());
        Area less = new Area(row.x(), row.y(), SIGN, row.height());
        Area more = new Area(row.right() - SIGN, row.y(), SIGN, row.height());
        pane.button(less, "–", Color.PANEL_LIT, words, () -> nudge.accept(-1));
        pane.value(value, words, Canvas.Font.WORDS, false);
        pane.button(more, "+", Color.PANEL_LIT, words, () -> nudge.accept(1));
    }

    /** A text over a whole row; a press on it begins to type. */
    void entry(String words, Shown shown, Runnable type) {
        Area row = row();
        pane.value(row, shown.text(), shown.font(), shown.isTyped());
        pane.spots().add(row, words, type);
    }

    void toggle(String words, boolean isOn, String told, Runnable flip) {
        Area row = row();
        Area label = new Area(row.x(), row.y(), row.width() - 44, row.height());
        pane.text(label, words, Canvas.Align.LEFT, pane.isHot(row) ? Color.TEXT : Color.TEXT_DIM);
        double middle = row.middleY();
        Color plate = isOn ? Color.GOOD : Color.PANEL_LIT;
        pane.canvas().panel(row.right() - 40, middle - 10, 40, 20, 10, plate);
        pane.canvas().disc(row.right() - (isOn ? 10 : 30), middle, 7, Color.TEXT);
        pane.spots().add(row, told, flip);
    }

    void button(String words, String told, Runnable action) {
        pane.button(row(), words, Color.PANEL_LIT, told, action);
    }

    /**
     * What a field shows.
     *
     * @param text its value, or what is typed into it
     * @param font words or numbers
     * @param isTyped whether it is being typed into
     */
    record Shown(String text, Canvas.Font font, boolean isTyped) {}
}

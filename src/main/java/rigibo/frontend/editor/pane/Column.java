package rigibo.frontend.editor.pane;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.widget.Spread;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

/**
 * Rows of fields, from the top of an area downwards. In a handheld window they are as high as a
 * finger, and there are as many on a page as there is room for.
 */
final class Column {

    private static final double ROW = 24;
    private static final double GAP = 2;
    private static final double SIGN = 22;
    private static final double VALUE = 66;

    /**
     * Share of a row that its value takes in a handheld window, where rows are as wide as the
     * window.
     */
    private static final double VALUE_SHARE = 0.3;

    /** Width that plus and minus give up to the value between them where text is enlarged, px. */
    private static final double SPARED = 5;

    private final Pane pane;
    private final Pages pages;
    private final double height;
    private Area area;
    private int rows;

    Column(Pane pane, Area area, Pages pages) {
        this.pane = pane;
        this.area = area;
        this.pages = pages;
        height = pane.pressable(ROW);
    }

    private double pitch() {
        return height + GAP;
    }

    private boolean isPaged() {
        return pane.canvas().layout().isInHand();
    }

    /** Rows of a page. In a handheld window the last row leads to other pages. */
    private int perPage() {
        return Math.max(1, (int) ((area.height() + GAP) / pitch()) - 1);
    }

    /** Draws the next row if it is on the open page. */
    private void row(Consumer<Area> drawing) {
        int at = isPaged() ? rows - pages.open() * perPage() : rows;
        rows++;
        if (!isPaged() || at >= 0 && at < perPage()) {
            drawing.accept(line(at));
        }
    }

    private Area line(int at) {
        return new Area(area.x(), area.y() + at * pitch(), area.width(), height);
    }

    /** Below the last row: leads to other pages, if there are any. */
    void foot() {
        int count = (rows + perPage() - 1) / perPage();
        if (!isPaged() || count < 2) {
            return;
        }
        pages.open(pages.open(), count);
        Area line = line(perPage());
        double third = (line.width() - 2 * GAP) / 3;
        turn(new Area(line.x(), line.y(), third, height), "‹", pages.open() - 1, count);
        turn(new Area(line.right() - third, line.y(), third, height), "›", pages.open() + 1, count);
        String where = (pages.open() + 1) + " / " + count;
        pane.text(line, where, Canvas.Align.CENTRE, Color.TEXT_DIM);
    }

    private void turn(Area place, String sign, int page, int count) {
        boolean isThere = page >= 0 && page < count;
        Color plate = isThere ? Color.PANEL_LIT : Color.DUSK_TOP;
        pane.button(place, sign, plate, "", () -> pages.open(page, count));
    }

    /** Names side by side, one of which is open, above all pages. */
    void tabs(List<String> names, int open, IntConsumer turn) {
        Area row = line(0);
        area = new Area(area.x(), area.y() + pitch(), area.width(), area.height() - pitch());
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
        row(row -> pane.text(row, words, Canvas.Align.LEFT, Color.BRASS));
    }

    void note(String words) {
        row(row -> pane.text(row, words, Canvas.Align.LEFT, Color.TEXT_DIM));
    }

    /** A value between a minus and a plus; a press on it begins to type. */
    void stepper(String words, Shown shown, Runnable type, IntConsumer nudge) {
        row(row -> stepper(row, words, shown, type, nudge));
    }

    private void stepper(Area row, String words, Shown shown, Runnable type, IntConsumer nudge) {
        double usual = pane.pressable(SIGN);
        double sign = pane.canvas().layout().type() > 1 ? usual - SPARED : usual;
        double held = isPaged() ? VALUE_SHARE * row.width() : VALUE;
        double left = row.right() - held - 2 * usual;
        Area label = new Area(row.x(), row.y(), left - row.x(), row.height());
        pane.text(label, words, Canvas.Align.LEFT, Color.TEXT_DIM);
        sign(new Area(left, row.y(), sign, row.height()), "–", words, () -> nudge.accept(-1));
        double room = row.right() - left - 2 * sign;
        Area value = new Area(left + sign, row.y(), room, row.height());
        value(value, words, shown, type);
        Area more = new Area(row.right() - sign, row.y(), sign, row.height());
        sign(more, "+", words, () -> nudge.accept(1));
    }

    private void sign(Area place, String sign, String words, Runnable action) {
        pane.button(place, sign, words + " " + sign, Color.PANEL_LIT, words, action);
    }

    private void value(Area place, String words, Shown shown, Runnable type) {
        pane.value(place, shown.text(), shown.font(), shown.isTyped());
        pane.spots().add(place, words + " " + shown.text(), words, type);
    }

    /** A value over a whole row, between a minus and a plus. */
    void wide(String words, IntConsumer nudge) {
        row(
                row -> {
                    double sign = pane.pressable(SIGN);
                    Area value =
                            new Area(row.x() + sign, row.y(), row.width() - 2 * sign, row.height());
                    sign(
                            new Area(row.x(), row.y(), sign, row.height()),
                            "–",
                            words,
                            () -> nudge.accept(-1));
                    pane.value(value, words, Canvas.Font.WORDS, false);
                    Area more = new Area(row.right() - sign, row.y(), sign, row.height());
                    sign(more, "+", words, () -> nudge.accept(1));
                });
    }

    /** A text over a whole row; a press on it begins to type. */
    void entry(String words, Shown shown, Runnable type) {
        row(row -> value(row, words, shown, type));
    }

    void toggle(String words, boolean isOn, String told, Runnable flip) {
        row(row -> toggle(row, words, isOn, told, flip));
    }

    private void toggle(Area row, String words, boolean isOn, String told, Runnable flip) {
        Area label = new Area(row.x(), row.y(), row.width() - 44, row.height());
        pane.text(label, words, Canvas.Align.LEFT, pane.isHot(row) ? Color.TEXT : Color.TEXT_DIM);
        double middle = row.middleY();
        Color plate = isOn ? Color.GOOD : Color.PANEL_LIT;
        pane.canvas().panel(row.right() - 40, middle - 10, 40, 20, 10, plate);
        pane.canvas().disc(row.right() - (isOn ? 10 : 30), middle, 7, Color.TEXT);
        pane.spots().add(row, words, Control.Kind.of(isOn), told, flip);
    }

    void button(String words, String told, Runnable action) {
        row(row -> pane.button(row, words, Color.PANEL_LIT, told, action));
    }

    /**
     * The content of a field.
     *
     * @param text its value, or the text being typed into it
     * @param font words or numbers
     * @param isTyped whether it is being typed into
     */
    record Shown(String text, Canvas.Font font, boolean isTyped) {}
}

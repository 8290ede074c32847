package rigibo.frontend.editor.pane;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** Buttons in a row, each as wide as its name. */
public final class Bar {

    private static final double GAP = 5;

    private final Pane pane;
    private final Area area;
    private double x;

    /** A bar whose buttons begin at the left of an area. */
    public Bar(Pane pane, Area area) {
        this.pane = pane;
        this.area = area;
        x = area.x();
    }

    /** Words before the buttons. */
    public void words(String sentence, Color ink) {
        double width = pane.width(sentence);
        pane.text(new Area(x, area.y(), width, area.height()), sentence, Canvas.Align.LEFT, ink);
        x += width + GAP;
    }

    /** The next button; dimmed where there is nothing to do. */
    public void button(String key, boolean isBright, Runnable action) {
        String name = pane.words().of("editor." + key);
        double width = pane.tightWidth(name);
        Area place = new Area(x, area.y(), width, area.height());
        Color plate = isBright ? Color.PANEL_LIT : Color.DUSK_TOP;
        pane.button(place, name, plate, pane.words().of("editor." + key + ".told"), action);
        x += width + GAP;
    }

    /** The area that is left at the right of the buttons. */
    public Area rest() {
        return new Area(x, area.y(), area.right() - x, area.height());
    }
}

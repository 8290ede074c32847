package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.picture.Skins;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.widget.Grid;
import rigibo.frontend.scene.widget.Plate;

import java.util.function.Consumer;

/** The tools on the left, bodies beside joints, with the materials below them. */
public final class ToolPane {

    private static final double SIZE = 40;
    private static final double PITCH = 44;
    private static final double SWATCH = 30;
    private static final double GAP = 4;

    /**
     * Number of rows: that of the tools for bodies, which are more than those for joints beside
     * them.
     */
    private static final int ROWS = 9;

    private static final int SWATCHES = 4;

    private ToolPane() {}

    /** Lays out as many side by side as fit, tools first, each as large as a finger. */
    public static void drawInHand(
            Pane pane, Area area, Desk desk, Craft taken, Consumer<Craft> take) {
        Grid grid = grid(pane, area);
        for (Craft craft : Craft.values()) {
            Area place = Area.of(grid.place(craft.ordinal()));
            tool(pane, place, craft, craft == taken, () -> take.accept(craft));
        }
        int first = first(grid);
        for (Substance substance : Substance.values()) {
            swatch(pane, Area.of(grid.place(first + substance.ordinal())), desk, substance);
        }
    }

    /** Height of the pane in a handheld window for a given width, px. */
    public static double heightInHand(Pane pane, double width) {
        Grid grid = grid(pane, new Area(0, 0, width, 0));
        return grid.height(first(grid) + Substance.values().length);
    }

    private static Grid grid(Pane pane, Area area) {
        double side = pane.pressable(SIZE);
        int columns = (int) ((area.width() + GAP) / (side + GAP));
        return new Grid(new Plate(area.x(), area.y(), side, side), columns, GAP, GAP);
    }

    /** The first of the materials, which begin with a row of their own. */
    private static int first(Grid grid) {
        int tools = Craft.values().length;
        return (tools + grid.columns() - 1) / grid.columns() * grid.columns();
    }

    /** Draws it; a press on a tool takes it up. */
    public static void draw(Pane pane, Area area, Desk desk, Craft taken, Consumer<Craft> take) {
        pane.plate(area);
        Area inner = area.inset(6);
        int bodies = 0;
        int joints = 0;
        for (Craft craft : Craft.values()) {
            boolean joins = craft.joint().isPresent();
            double x = inner.x() + (joins ? PITCH : 0);
            double y = inner.y() + (joins ? joints++ : bodies++) * PITCH;
            tool(pane, new Area(x, y, SIZE, SIZE), craft, craft == taken, () -> take.accept(craft));
        }
        for (Substance substance : Substance.values()) {
            int at = substance.ordinal();
            double x = inner.x() + at / SWATCHES * PITCH + (SIZE - SWATCH) / 2;
            double y = inner.y() + ROWS * PITCH + 8 + at % SWATCHES * (SWATCH + 6);
            swatch(pane, new Area(x, y, SWATCH, SWATCH), desk, substance);
        }
    }

    private static void tool(Pane pane, Area area, Craft craft, boolean isTaken, Runnable take) {
        Color plate = isTaken ? Color.BRASS : pane.isHot(area) ? Color.EDGE : Color.PANEL_LIT;
        Color ink = isTaken ? Color.DUSK_TOP : Color.TEXT;
        Canvas canvas = pane.canvas();
        canvas.panel(area.x(), area.y(), area.width(), area.height(), 9, plate);
        craft.draw(canvas, area.middleX(), area.middleY(), ink);
        String told = pane.words().of("editor.tool." + craft.key());
        pane.spots().add(area, told, Control.Kind.of(isTaken), told, take);
    }

    private static void swatch(Pane pane, Area area, Desk desk, Substance substance) {
        boolean isChosen = desk.substance() == substance;
        double x = area.middleX();
        double y = area.middleY();
        if (isChosen) {
            pane.canvas().ring(x, y, 14, 3, 1, Color.BRASS);
        }
        pane.canvas().disc(x, y, pane.isHot(area) ? 12 : 11, Skins.of(substance).color);
        String name = pane.words().of("editor.material." + substance.title());
        String key = String.valueOf(substance.ordinal() + 1);
        pane.spots()
                .add(
                        area,
                        name,
                        Control.Kind.of(isChosen),
                        pane.words().of(told(substance), name, key),
                        () -> desk.substance(substance));
    }

    private static String told(Substance substance) {
        return substance == Substance.EMBER ? "editor.material.ember.told" : "editor.material";
    }
}

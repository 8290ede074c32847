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

/** The tools for bodies and joints, and the materials. */
public final class ToolPane {

    private static final double SIZE = 40;
    private static final double PITCH = 44;
    private static final double SWATCH = 30;
    private static final double GAP = 4;

    /** Number of tools for bodies, which come first, and are more than those for joints. */
    private static final int BODIES = 9;

    private static final int JOINTS = Craft.values().length - BODIES;
    private static final int MATERIALS = Substance.values().length;

    private static final int SWATCHES = 4;

    private ToolPane() {}

    /**
     * Lays out bodies, joints and materials below each other in rows as short as they can be, each
     * place as large as a finger in a handheld window.
     */
    public static void drawInRows(
            Pane pane, Area area, Desk desk, Craft taken, Consumer<Craft> take) {
        Grid bodies = rows(pane, area, BODIES, SIZE);
        Area below = area.lowered(bodies.height(BODIES) + GAP);
        Grid joints = rows(pane, below, JOINTS, SIZE);
        for (Craft craft : Craft.values()) {
            int at = craft.ordinal();
            Area place = Area.of(at < BODIES ? bodies.place(at) : joints.place(at - BODIES));
            tool(pane, place, craft, craft == taken, () -> take.accept(craft));
        }
        Area last = below.lowered(joints.height(JOINTS) + GAP);
        Grid materials = rows(pane, last, MATERIALS, SWATCH);
        for (Substance substance : Substance.values()) {
            swatch(pane, Area.of(materials.place(substance.ordinal())), desk, substance);
        }
    }

    /** Height of the rows for a given width, px. */
    public static double heightInRows(Pane pane, double width) {
        Area area = new Area(0, 0, width, 0);
        return rows(pane, area, BODIES, SIZE).height(BODIES)
                + GAP
                + rows(pane, area, JOINTS, SIZE).height(JOINTS)
                + GAP
                + rows(pane, area, MATERIALS, SWATCH).height(MATERIALS);
    }

    /** A number of places in as few rows as an area has room for, all about as long. */
    private static Grid rows(Pane pane, Area area, int places, double size) {
        double side = pane.pressable(size);
        int most = (int) ((area.width() + GAP) / (side + GAP));
        int rows = (places + most - 1) / most;
        int columns = (places + rows - 1) / rows;
        return new Grid(new Plate(area.x(), area.y(), side, side), columns, GAP, GAP);
    }

    /** Draws bodies beside joints, with the materials below; a press on a tool takes it up. */
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
            double y = inner.y() + BODIES * PITCH + 8 + at % SWATCHES * (SWATCH + 6);
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

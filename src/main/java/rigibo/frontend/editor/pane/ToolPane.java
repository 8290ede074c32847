package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.picture.Skins;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.function.Consumer;

/** The tools on the left, bodies beside joints, with the materials below them. */
public final class ToolPane {

    private static final double SIZE = 40;
    private static final double PITCH = 44;
    private static final double SWATCH = 30;

    /** Tools for bodies, which are more than those for joints beside them. */
    private static final int ROWS = 9;

    private static final int SWATCHES = 4;

    private ToolPane() {}

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
        canvas.panel(area.x(), area.y(), SIZE, SIZE, 9, plate);
        craft.draw(canvas, area.middleX(), area.middleY(), ink);
        pane.spots().add(area, pane.words().of("editor.tool." + craft.key()), take);
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
                        pane.words().of("editor.material", name, key),
                        () -> desk.substance(substance));
    }
}

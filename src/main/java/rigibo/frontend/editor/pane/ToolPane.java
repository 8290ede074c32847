package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.puzzle.Skins;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.function.Consumer;

/** The column of tools at the left, and below it what bodies are made of. */
public final class ToolPane {

    private static final double SIZE = 44;
    private static final double PITCH = 48;
    private static final double SWATCH = 30;

    private ToolPane() {}

    /** Draws it; a press on a tool takes it up. */
    public static void draw(Pane pane, Area area, Desk desk, Craft taken, Consumer<Craft> take) {
        pane.plate(area);
        double x = area.x() + (area.width() - SIZE) / 2;
        double y = area.y() + 6;
        for (Craft craft : Craft.values()) {
            tool(pane, new Area(x, y, SIZE, SIZE), craft, craft == taken, () -> take.accept(craft));
            y += PITCH;
        }
        y += 6;
        for (Substance substance : Substance.values()) {
            swatch(pane, new Area(x + 7, y, SWATCH, SWATCH), desk, substance);
            y += SWATCH + 6;
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

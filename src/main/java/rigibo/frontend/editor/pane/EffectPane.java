package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.EffectUse;
import rigibo.frontend.scene.Color;

import java.util.List;

/** The effects as chips, bright where declared; a press declares an effect or removes it. */
public final class EffectPane {

    private static final double CHIP = 25;
    private static final double GAP = 5;
    private static final double TIGHT_GAP = 3;

    /** What a tight chip has less beside its name, px. */
    private static final double TIGHTENED = 11;

    /** What a level may declare, what is common first. */
    private static final List<String> EFFECTS =
            List.of(
                    "gravity",
                    "contacts",
                    "rotation",
                    "friction",
                    "restitution",
                    "rolling-resistance",
                    "surface-speed",
                    "buoyancy",
                    "drag",
                    "joints",
                    "fan",
                    "magnet",
                    "continuous-impacts",
                    "sleep");

    private EffectPane() {}

    /** Draws it in as many rows as it takes. */
    public static void draw(Pane pane, Area area, Desk desk) {
        List<String> declared = EffectUse.declared(desk.draft());
        // Where text is enlarged, two rows are still all there is room for.
        boolean isTight = pane.canvas().layout().type() > 1;
        double tightened = isTight ? TIGHTENED : 0;
        double gap = isTight ? TIGHT_GAP : GAP;
        double x = area.x();
        double y = area.y();
        for (String effect : EFFECTS) {
            String name = pane.words().of("editor.effect." + effect);
            double width = pane.width(name) - tightened;
            if (x + width > area.right()) {
                x = area.x();
                y += CHIP + GAP;
            }
            boolean isDeclared = declared.contains(effect);
            pane.button(
                    new Area(x, y, width, CHIP),
                    name,
                    isDeclared ? Color.BRASS : Color.PANEL_LIT,
                    pane.words().of(isDeclared ? "editor.declared" : "editor.undeclared", name),
                    () -> desk.change(EffectUse.switched(desk.draft(), effect)));
            x += width + gap;
        }
    }
}

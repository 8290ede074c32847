package rigibo.frontend.editor.pane;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.EffectUse;
import rigibo.frontend.scene.Color;

import java.util.ArrayList;
import java.util.List;

/** The effects as chips, bright where declared; a press declares an effect or removes it. */
public final class EffectPane {

    private static final double USUAL_CHIP = 25;
    private static final double GAP = 5;
    private static final double TIGHT_GAP = 3;

    /** The effects that a level may declare, the most common first. */
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

    /** Height of the rows that it takes in an area, px; two at least. */
    public static double height(Pane pane, Area area) {
        List<Area> places = places(pane, area);
        double chip = pane.pressable(USUAL_CHIP);
        double bottom = places.get(places.size() - 1).y() + chip;
        return Math.max(2 * chip + GAP, bottom - area.y());
    }

    /** Draws it in as many rows as it takes. */
    public static void draw(Pane pane, Area area, Desk desk) {
        List<String> declared = EffectUse.declared(desk.draft());
        List<Area> places = places(pane, area);
        for (int i = 0; i < places.size(); i++) {
            String effect = EFFECTS.get(i);
            String name = name(pane, effect);
            boolean isDeclared = declared.contains(effect);
            pane.button(
                    places.get(i),
                    name,
                    isDeclared ? Color.BRASS : Color.PANEL_LIT,
                    pane.words().of(isDeclared ? "editor.declared" : "editor.undeclared", name),
                    () -> desk.change(EffectUse.switched(desk.draft(), effect)));
        }
    }

    /** Tight where that spares a row. */
    private static List<Area> places(Pane pane, Area area) {
        List<Area> loose = places(pane, area, 0, GAP);
        List<Area> tight = places(pane, area, Pane.TIGHTENED, TIGHT_GAP);
        int last = EFFECTS.size() - 1;
        return tight.get(last).y() < loose.get(last).y() ? tight : loose;
    }

    private static List<Area> places(Pane pane, Area area, double tightened, double gap) {
        List<Area> places = new ArrayList<>();
        double chip = pane.pressable(USUAL_CHIP);
        double x = area.x();
        double y = area.y();
        for (String effect : EFFECTS) {
            double width = Math.max(pane.pressable(0), pane.width(name(pane, effect)) - tightened);
            if (x + width > area.right()) {
                x = area.x();
                y += chip + GAP;
            }
            places.add(new Area(x, y, width, chip));
            x += width + gap;
        }
        return places;
    }

    private static String name(Pane pane, String effect) {
        return pane.words().of("effect." + effect);
    }
}
